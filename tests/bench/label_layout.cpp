#include "label_layout.hpp"

#include <algorithm>
#include <cmath>

namespace nacre::bench {
namespace {

constexpr double pointRadius = 6.0;  // pixels that a mark covers, with some air

Box boxOf(double left, double middle, double width, double height)
{
    return {left, middle - 0.5 * height, left + width, middle + 0.5 * height};
}

bool isInside(const Box& box, const Box& frame)
{
    return box.left >= frame.left && box.right <= frame.right && box.bottom >= frame.bottom && box.top <= frame.top;
}

}  // namespace

bool Box::overlaps(const Box& other) const
{
    return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
}

std::vector<PlacedLabel> placeLabels(const std::vector<LabelledPoint>& points, const Box& frame, double characterWidth, double lineHeight)
{
    std::vector<Box> taken;
    for (const LabelledPoint& point : points) taken.push_back(boxOf(point.x - pointRadius, point.y, 2.0 * pointRadius, 2.0 * pointRadius));

    std::vector<PlacedLabel> placed;
    for (const LabelledPoint& point : points) {
        const double width = characterWidth * static_cast<double>(point.label.size());
        PlacedLabel best{point.x + 1.5 * pointRadius, point.y, false};
        bool isFound = point.label.empty();
        // Around the point, ring after ring; sixteen directions, the right first, then alternating from it.
        for (int ring = 0; ring < 12 && !isFound; ++ring) {
            for (int step = 0; step < 16 && !isFound; ++step) {
                const double angle = (step % 2 ? 1.0 : -1.0) * (step + 1) / 2 * 0.392699;
                const double reach = 1.5 * pointRadius + ring * 0.8 * lineHeight;
                const double x = point.x + reach * std::cos(angle), y = point.y + reach * std::sin(angle);
                // The text lies on the far side of the place, as seen from the point.
                const double left = x - 0.5 * width * (1.0 - std::clamp(2.0 * std::cos(angle), -1.0, 1.0));
                const double middle = y + 0.5 * lineHeight * std::clamp(2.0 * std::sin(angle), -1.0, 1.0);
                const Box box = boxOf(left, middle, width, lineHeight);
                const auto overlaps = [&](const Box& other) { return box.overlaps(other); };
                if (!isInside(box, frame) || std::any_of(taken.begin(), taken.end(), overlaps)) continue;
                best = {left, middle, ring > 0};
                isFound = true;
            }
        }
        if (!point.label.empty()) taken.push_back(boxOf(best.x, best.y, width, lineHeight));
        placed.push_back(best);
    }
    return placed;
}

}  // namespace nacre::bench
