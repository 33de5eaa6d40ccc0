// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/spreadtexels.h"

#include <algorithm>
#include <cassert>
#include <opencv2/imgproc.hpp>

namespace quadrille {

void spreadTexels(const UsedTexels& texels, Image& texture)
{
    assert(texture.width == texels.width && texture.height == texels.height);
    for (std::size_t at = 3; at < texture.pixels.size(); at += 4)
        texture.pixels[at] = 255;
    if (texels.texels.empty())
        return;
    cv::Mat unused(texels.height, texels.width, CV_8UC1, cv::Scalar(1));
    for (const std::uint32_t texel : texels.texels)
        unused.data[texel] = 0;
    cv::Mat distances;
    cv::Mat nearest; // labels are given in an order of OpenCV's own
    cv::distanceTransform(unused, distances, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
    const auto* labels = nearest.ptr<std::int32_t>();
    std::vector<std::uint32_t> texelOf(texels.texels.size() + 1, texels.texels.front());
    for (const std::uint32_t texel : texels.texels)
        texelOf[static_cast<std::size_t>(labels[texel])] = texel;
    const auto count = static_cast<std::size_t>(texels.width) * static_cast<std::size_t>(texels.height);
    for (std::size_t at = 0; at < count; ++at) {
        const std::size_t from = texelOf[static_cast<std::size_t>(labels[at])];
        std::copy_n(texture.pixels.data() + 4 * from, 3, texture.pixels.data() + 4 * at);
    }
}

} // namespace quadrille
