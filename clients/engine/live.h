// A valve that moves under the hand (core/live), as the page has it: documents in, pictures out as flat lists of numbers.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "clients/engine/engine.h"
#include "core/live/live_valve.h"

namespace coapt {

struct RepairRequest;

class LiveEngine {
 public:
  /// A body of "valve", "plan" (optional) and "pressure_mmhg" (optional, else that of systole): another valve, from its
  /// unstressed shape. Answers "scene" (coapt.scene/2, not closed), "systole_mmhg" and "cables": [chorda, segment] each,
  /// chorda -1 for ties; "hooks": whether each holds something. What cannot be read is refused as by answer(), and the valve before goes on.
  EngineAnswer start(std::string_view body);
  /// A body of "valve" and "plan": goes on with it from where the leaflets are, if the mesh is the same. Answers alike.
  /// @pre started.
  EngineAnswer change(std::string_view body);

  LiveValve* valve() { return moving_ ? &*moving_ : nullptr; }  ///< null until started

  /// As it is now, mm and N:
  ///   pressure_mmhg, at_rest, beats (0 or 1), returns, the longest move in the last step;
  ///   of each hook whether it holds something, its spot, the hand, its force: 10 numbers, 0 if it holds nothing;
  ///   the nodes as in Scene.motion_mm, three numbers each;
  ///   tension and strain of each cable.
  /// Lasts until the next one is taken. @pre started.
  const std::vector<float>& take_picture();
  const std::vector<float>& picture() const { return picture_; }  ///< the last that was taken

  int vertices() const { return vertices_; }
  int cables() const { return cables_; }

 private:
  EngineAnswer started(const RepairRequest& asked);

  std::optional<LiveValve> moving_;
  Index heads_ = 0, knots_ = 0;
  int vertices_ = 0, cables_ = 0;
  std::vector<float> picture_;
};

}  // namespace coapt
