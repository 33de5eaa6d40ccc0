// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/appearance/flow.h"

#include "model/core/badargument.h"

#include <opencv2/imgproc.hpp>
#include <opencv2/optflow.hpp>
#include <opencv2/video/tracking.hpp>

namespace quadrille {

namespace {

/// Work is shared out by Executor, and DISOpticalFlow cuts pictures by the number of threads: OpenCV gets
/// one, before anything can use it.
[[maybe_unused]] const bool openCvHasOneThread = [] {
    cv::setNumThreads(1);
    return true;
}();

cv::Mat coverOf(const UsedTexels& used)
{
    cv::Mat mask(used.height, used.width, CV_32F, cv::Scalar(0));
    for (std::size_t k = 0; k < used.texels.size(); ++k)
        mask.ptr<float>()[used.texels[k]] = static_cast<float>(used.covered[k]);
    return mask;
}

/// Brightness without its local mean, in local deviations, as grey in [0, 1]; the middle outside the charts.
cv::Mat normalised(const Image& texture, const cv::Mat& mask, double radius)
{
    constexpr double floor = 4;   // of deviations, in grey levels: less is noise
    constexpr double gain = 0.15; // so that three deviations fit in
    const cv::Mat pixels(texture.height, texture.width, CV_8UC4,
                         const_cast<std::uint8_t*>(texture.pixels.data()));
    cv::Mat grey;
    cv::cvtColor(pixels, grey, cv::COLOR_RGBA2GRAY);
    grey.convertTo(grey, CV_32F);
    cv::Mat weights;
    cv::GaussianBlur(mask, weights, {}, radius);
    cv::max(weights, 1e-3, weights);
    const auto localMean = [&](const cv::Mat& values) {
        cv::Mat mean;
        cv::GaussianBlur(values.mul(mask), mean, {}, radius);
        cv::divide(mean, weights, mean);
        return mean;
    };
    const cv::Mat detail = grey - localMean(grey);
    cv::Mat deviation;
    cv::sqrt(localMean(detail.mul(detail)), deviation);
    cv::Mat result;
    cv::divide(detail.mul(mask), deviation + floor, result);
    result = result * gain + 0.5;
    cv::max(result, 0.0, result);
    cv::min(result, 1.0, result);
    return result;
}

/// The settings were chosen by the error on textures with known warps and lights; see bench_appearance.
cv::Mat disFlow(const cv::Mat& fixed, const cv::Mat& moving)
{
    cv::Mat bytes[2];
    fixed.convertTo(bytes[0], CV_8U, 255);
    moving.convertTo(bytes[1], CV_8U, 255);
    const auto search = cv::DISOpticalFlow::create(cv::DISOpticalFlow::PRESET_MEDIUM);
    search->setFinestScale(0);
    search->setVariationalRefinementIterations(20);
    search->setVariationalRefinementAlpha(60);
    cv::Mat flow;
    search->calc(bytes[0], bytes[1], flow);
    return flow;
}

void refineByTvL1(const cv::Mat& fixed, const cv::Mat& moving, double lambda, cv::Mat& flow,
                  const Progress& progress)
{
    constexpr int warps = 3;
    const auto refinement = cv::optflow::DualTVL1OpticalFlow::create();
    refinement->setLambda(lambda);
    refinement->setScalesNumber(1);
    refinement->setWarpingsNumber(1);
    refinement->setInnerIterations(10);
    refinement->setOuterIterations(2);
    refinement->setUseInitialFlow(true);
    for (int warp = 0; warp < warps; ++warp) {
        progress.report(warp, warps);
        refinement->calc(fixed, moving, flow);
    }
}

} // namespace

std::vector<Vec2f> denseFlow(const Image& fixed, const Image& moving, const ChartLookup& charts,
                             const FlowOptions& options, const Progress& progress)
{
    const UsedTexels& used = charts.used();
    if (used.width < 32 || used.height < 32)
        refuse("Textures of less than 32 × 32 texels cannot be aligned",
               "Use them as they are, or larger ones.");
    progress.report(0);
    const cv::Mat mask = coverOf(used);
    const cv::Mat from = normalised(fixed, mask, options.normalisation);
    const cv::Mat to = normalised(moving, mask, options.normalisation);
    progress.report(0.1);
    cv::Mat flow = disFlow(from, to);
    if (options.method == FlowMethod::TvL1)
        refineByTvL1(from, to, options.lambda, flow, progress.part(0.3, 1));
    std::vector<Vec2f> field(used.texels.size());
    for (std::size_t k = 0; k < field.size(); ++k) {
        const cv::Vec2f& found = flow.ptr<cv::Vec2f>()[used.texels[k]];
        field[k] = Vec2f(found[0], found[1]);
    }
    charts.keepInside(field);
    progress.report(1);
    return field;
}

} // namespace quadrille
