// SPDX-License-Identifier: Apache-2.0
#include "output/pictures/camera.hpp"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace aneurysm::pictures
{
namespace
{

constexpr double opening_angle = 20; ///< of the camera, small: parallel lines stay nearly parallel [deg]

struct Angles {
    double around; ///< the y axis, from +z toward +x [deg]
    double above;  ///< the x-z plane [deg]
};

Angles angles_of(View view)
{
    switch (view) {
    case View::front:
        return {0, 0};
    case View::tilted:
        return {28, 16};
    case View::side:
        return {90, 0};
    case View::sac:
        return {22, 14};
    case View::breach:
        return {25, 52};
    }
    return {0, 0};
}

/// Balls that hold what has to be in the picture.
struct Ball {
    Vec3 center;
    double radius = 0;
};

std::vector<Ball> balls_of(const Vessel& vessel, View view)
{
    const double r_0 = vessel.openings()[0].radius;
    const double R = vessel.has_sac() ? vessel.largest_radius() : 0;
    const Ball sac{vessel.dome(R) - Vec3{0, R, 0}, R};
    if (view == View::sac || view == View::breach) {
        const double top = vessel.dome(R).y + 0.9 * r_0; // blood that leaves
        const double bottom = vessel.apex() - 1.5 * r_0;
        return {{{0, 0.5 * (top + bottom), 0}, 0.5 * (top - bottom)}};
    }
    std::vector<Ball> balls{sac};
    for (std::size_t k = 0; k < 3; ++k) {
        balls.push_back({vessel.openings()[k].center, vessel.openings()[k].radius});
    }
    return balls;
}

} // namespace

void look(vtkRenderer& renderer, const Vessel& vessel, View view, double width, double height)
{
    const double radian = std::numbers::pi / 180;
    const auto [around, above] = angles_of(view);
    const Vec3 back{std::sin(around * radian) * std::cos(above * radian), std::sin(above * radian),
                    std::cos(around * radian) * std::cos(above * radian)};
    const Vec3 right{std::cos(around * radian), 0, -std::sin(around * radian)};
    const Vec3 up = cross(back, right);
    double left_most = 1e9, right_most = -1e9, low_most = 1e9, high_most = -1e9;
    for (const Ball& ball : balls_of(vessel, view)) {
        left_most = std::min(left_most, dot(ball.center, right) - ball.radius);
        right_most = std::max(right_most, dot(ball.center, right) + ball.radius);
        low_most = std::min(low_most, dot(ball.center, up) - ball.radius);
        high_most = std::max(high_most, dot(ball.center, up) + ball.radius);
    }
    const Vec3 middle = 0.5 * (left_most + right_most) * right + 0.5 * (low_most + high_most) * up;
    const double aspect = renderer.GetTiledAspectRatio();
    const double slope = std::tan(0.5 * opening_angle * radian); // of the picture's upper edge
    double distance = 0;
    for (const Ball& ball : balls_of(vessel, view)) {
        const Vec3 offset = ball.center - middle;
        const double across = (std::abs(dot(offset, right)) + ball.radius) / (width * aspect);
        const double along = (std::abs(dot(offset, up)) + ball.radius) / height;
        distance = std::max(distance, std::max(across, along) / slope + dot(offset, back));
    }
    const Vec3 eye = middle + distance * back;
    vtkCamera& camera = *renderer.GetActiveCamera();
    camera.SetViewAngle(opening_angle);
    camera.SetFocalPoint(middle.x, middle.y, middle.z);
    camera.SetPosition(eye.x, eye.y, eye.z);
    camera.SetViewUp(up.x, up.y, up.z);
    renderer.ResetCameraClippingRange();
}

} // namespace aneurysm::pictures
