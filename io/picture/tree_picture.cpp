#include "io/picture/tree_picture.h"

#include <algorithm>

#include "io/picture/chart_frame.h"
#include "io/picture/svg.h"
#include "io/picture/text.h"

namespace coapt {
namespace {

constexpr double kTreeLeft_px = 20.0, kIndent_px = 30.0, kBranch_px = 40.0, kRepair_px = 470.0;

class TreeDrawing {
 public:
  TreeDrawing(const PopulationTree& tree, double top) : tree_(tree), y_(top) {}

  /// The branches below a node, from `x`; returns nothing: see svg() and bottom().
  void draw_below(int node, double x) {
    const TreeNode& at = tree_.tree.nodes[static_cast<std::size_t>(node)];
    const double from = y_;
    double last = y_;
    for (const bool above : {false, true}) {
      y_ += kBranch_px;
      last = y_;
      const int child = above ? at.above : at.below;
      svg_ += line_at("axis", x, y_ - 5.0, x + 16.0, y_ - 5.0) +
              text_at(x + 22.0, y_, "class=\"legend\"", question_of(tree_.tree, node, above));
      if (tree_.tree.nodes[static_cast<std::size_t>(child)].feature < 0)
        draw_leaf(child);
      else
        draw_below(child, x + kIndent_px);
    }
    svg_ += line_at("axis", x, from + 8.0, x, last - 5.0);
  }

  void draw_leaf(int node) {
    const TreeNode& at = tree_.tree.nodes[static_cast<std::size_t>(node)];
    svg_ += text_at(kRepair_px, y_, "class=\"head\"",
                    candidate_repairs()[static_cast<std::size_t>(at.choice)].name);
    for (const TreeLeaf& leaf : tree_.leaves)
      if (leaf.node == node)
        svg_ += text_at(kRepair_px, y_ + 15.0, "class=\"tick\"",
                        counted(leaf.members, "held-out valve") + ", residual leak " +
                            fixed(leaf.leak_mm2.mean, 1) + " mm² (" + fixed(leaf.leak_mm2.low, 1) +
                            " to " + fixed(leaf.leak_mm2.high, 1) + "), costs " +
                            fixed(leaf.regret.mean, 1) + " more than the best");
  }

  const std::string& svg() const { return svg_; }
  double bottom() const { return y_ + 30.0; }

 private:
  const PopulationTree& tree_;
  double y_;
  std::string svg_;
};

}  // namespace

std::string tree_svg(const PopulationTree& tree) {
  const std::string title = "Decision tree for the repair";
  const Drawn heading = draw_heading({title,
                                      "Trained on " + std::to_string(tree.grown_on) +
                                          " valves, pruned on " + std::to_string(tree.pruned_on) +
                                          ", tested on " + std::to_string(tree.judged_on) +
                                          " others. Brackets: 95 % interval of the mean.",
                                      {}});
  TreeDrawing drawing(tree, heading.bottom + 20.0);
  if (tree.tree.nodes.front().feature < 0)
    drawing.draw_leaf(0);
  else
    drawing.draw_below(0, kTreeLeft_px);
  return figure_svg(title, heading.svg + drawing.svg(), {drawing.bottom()});
}

}  // namespace coapt
