// SPDX-FileCopyrightText: 2026 The Quadrille developers
// SPDX-License-Identifier: MIT
#include "model/sample/groundtruth.h"

#include "model/core/npy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

namespace quadrille {

namespace {

using Json = nlohmann::ordered_json;

/// Seven digits: exact for metres and weights, and short.
double rounded(double value)
{
    return std::round(value * 1e7) / 1e7;
}

Json toJson(const Vec3d& v)
{
    return Json::array({rounded(v.x()), rounded(v.y()), rounded(v.z())});
}

/// Degrees about Z, X and Y with R = Z X Y.
std::array<double, 3> zxyDegrees(const Eigen::Quaterniond& q)
{
    const Eigen::Matrix3d m = q.toRotationMatrix();
    const double x = std::asin(std::clamp(m(2, 1), -1.0, 1.0));
    const double z = std::atan2(-m(0, 1), m(1, 1));
    const double y = std::atan2(-m(2, 0), m(2, 2));
    constexpr double degrees = 180 / std::numbers::pi;
    return {z * degrees, x * degrees, y * degrees};
}

void append(std::string& text, const char* format, auto... values)
{
    std::array<char, 160> line{};
    const int length = std::snprintf(line.data(), line.size(), format, values...);
    text.append(line.data(), static_cast<std::size_t>(length));
}

void appendJoint(std::string& text, const Skeleton& skeleton, std::size_t joint, int depth,
                 std::vector<std::size_t>& order)
{
    order.push_back(joint);
    const std::string indent(static_cast<std::size_t>(depth) * 2, ' ');
    const bool isRoot = skeleton.parents[joint] < 0;
    const Vec3d offset =
        isRoot
            ? skeleton.rest[joint]
            : Vec3d(skeleton.rest[joint] - skeleton.rest[static_cast<std::size_t>(skeleton.parents[joint])]);
    text += indent + (isRoot ? "ROOT " : "JOINT ") + skeleton.names[joint] + "\n" + indent + "{\n";
    append(text, "%s  OFFSET %.6f %.6f %.6f\n", indent.c_str(), offset.x(), offset.y(), offset.z());
    text += indent + (isRoot ? "  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
                             : "  CHANNELS 3 Zrotation Xrotation Yrotation\n");
    bool isLeaf = true;
    for (std::size_t child = joint + 1; child < skeleton.size(); ++child)
        if (skeleton.parents[child] == static_cast<int>(joint)) {
            appendJoint(text, skeleton, child, depth + 1, order);
            isLeaf = false;
        }
    if (isLeaf) {
        const Vec3d end = 0.5 * offset;
        append(text, "%s  End Site\n%s  {\n%s    OFFSET %.6f %.6f %.6f\n%s  }\n", indent.c_str(),
               indent.c_str(), indent.c_str(), end.x(), end.y(), end.z(), indent.c_str());
    }
    text += indent + "}\n";
}

} // namespace

std::string toBvh(const Skeleton& skeleton, const std::vector<SkeletonPose>& poses, double fps)
{
    std::string text = "HIERARCHY\n";
    std::vector<std::size_t> order;
    appendJoint(text, skeleton, 0, 0, order);
    append(text, "MOTION\nFrames: %zu\nFrame Time: %.8f\n", poses.size(), 1 / fps);
    for (const SkeletonPose& pose : poses) {
        append(text, "%.6f %.6f %.6f", pose.root.x(), pose.root.y(), pose.root.z());
        for (const std::size_t joint : order) {
            const auto angles = zxyDegrees(pose.rotations[joint]);
            append(text, " %.5f %.5f %.5f", angles[0], angles[1], angles[2]);
        }
        text += "\n";
    }
    return text;
}

Json skeletonJson(const SampleCharacter& character)
{
    const Skeleton& skeleton = character.skeleton;
    Json joints = Json::array();
    for (std::size_t j = 0; j < skeleton.size(); ++j)
        joints.push_back({{"name", skeleton.names[j]},
                          {"parent", skeleton.parents[j]},
                          {"rest_metres", toJson(skeleton.rest[j])}});
    Json vertexJoints = Json::array();
    Json vertexWeights = Json::array();
    for (const VertexWeights& w : character.weights) {
        vertexJoints.push_back(w.joints);
        Json weights = Json::array();
        for (const float weight : w.weights)
            weights.push_back(rounded(static_cast<double>(weight)));
        vertexWeights.push_back(weights);
    }
    return {{"joints", joints}, {"vertex_joints", vertexJoints}, {"vertex_weights", vertexWeights}};
}

Json takesJson(const SampleCharacter& character)
{
    Json takes = Json::array();
    for (const SampleTake& take : character.takes) {
        Json contacts = Json::array();
        for (const ContactSpan& span : take.sequence.contacts)
            contacts.push_back(
                {{"foot", span.foot}, {"frames", {span.frames.first.value, span.frames.last.value}}});
        Json json = {{"name", take.sequence.name},
                     {"kind", take.kind},
                     {"frames", take.sequence.frameCount()},
                     {"contacts", contacts}};
        if (take.flight.count() > 0)
            json["flight"] = {take.flight.first.value, take.flight.last.value};
        if (take.appearance) {
            Json lights = Json::array();
            for (const SampleLight& light : take.appearance->lights)
                lights.push_back({{"to_light", toJson(light.direction)},
                                  {"colour", toJson(light.colour)},
                                  {"ambient", toJson(light.ambient)}});
            json["lighting"] = lights;
            json["texture_size"] = take.appearance->textureSize;
        }
        takes.push_back(json);
    }
    return {{"takes", takes}};
}

Json landmarksJson(const SampleCharacter& character)
{
    const auto point = [](const SurfacePoint& p) {
        return Json{{"triangle", p.triangle.value}, {"weights", toJson(p.weights)}};
    };
    Json marks = Json::array();
    for (const LandmarkPair& pair : character.landmarks)
        marks.push_back(
            {{"name", pair.name}, {"source", point(pair.source)}, {"target", point(pair.target)}});
    return {{"source", character.body.name}, {"target", character.target.name}, {"landmarks", marks}};
}

std::string warpsNpy(const SampleAppearance& appearance)
{
    const std::array shape{static_cast<std::int64_t>(appearance.warps.size()),
                           std::int64_t{SampleWarp::nodes}, std::int64_t{SampleWarp::nodes}, std::int64_t{2}};
    std::string bytes = npyHeader("'<f4'", shape);
    for (const SampleWarp& warp : appearance.warps)
        bytes.append(reinterpret_cast<const char*>(warp.offsets.data()), warp.offsets.size() * sizeof(Vec2f));
    return bytes;
}

} // namespace quadrille
