#pragma once

#include <string>
#include <vector>

namespace nacre::bench {

/// In pixels, y upwards.
struct Box {
    double left = 0.0, bottom = 0.0, right = 0.0, top = 0.0;
    bool overlaps(const Box& other) const;
};

struct LabelledPoint {
    double x = 0.0, y = 0.0;
    std::string label;  ///< Empty: a point that only is in the way.
};

struct PlacedLabel {
    double x = 0.0, y = 0.0;  ///< Of the text's left edge and its middle.
    bool isFar = false;       ///< A line should lead to it.
};

/// A place for each label within the frame, on no other label and no point: the nearest of some around its
/// point. Greedy, in the points' order; where nothing is free the label stands to the right of its point.
std::vector<PlacedLabel> placeLabels(const std::vector<LabelledPoint>& points, const Box& frame, double characterWidth, double lineHeight);

}  // namespace nacre::bench
