// A brush drawn over the surface (texelcast.h, "Strokes"): each dab is cast like a decal of its own into scratch tiles, and
// these are laid over what the stroke has so far. Opacity and blending of the whole are the compositor's, as with any
// layer.
#pragma once

#include <memory>
#include <vector>

#include "picture_cast.h"
#include "round_tips.h"

namespace txc {

/// A stroke layer's own state.
struct Stroke {
    explicit Stroke(MemoryBudget& budget) : share(budget) {}

    std::vector<TxcDab> dabs;               // in order
    std::size_t painted = 0;                // so many of them are in the layer's tiles
    std::shared_ptr<RoundTips> round_tips;  // while the brush has a round one
    BudgetShare share;                      // of `dabs`

    /// Adds dabs, whose numbers must be checked: all or none. Errors: BAD_ARGUMENT, OUT_OF_BUDGET.
    TxcStatus add(const TxcDab* added, std::uint32_t count);
    /// Gives back all that it holds.
    void clear();
};

/// A dab with the projector of a layer's fields, and full flow.
TxcDab dab_from_def(const TxcLayerDef& def);
/// BAD_ARGUMENT names the field; `cast` takes the projector.
TxcStatus read_dab(const TxcDab& dab, PictureCast& cast);

/// Of a limit of work: texels, and what a picture costs that paints none.
class WorkLeft {
public:
    void begin(std::uint32_t limit) { left_ = limit == TXC_NONE ? INT64_MAX : limit; }
    bool any() const { return left_ > 0; }
    void spend(std::uint32_t texels) { left_ -= std::int64_t{texels} + kCast; }

private:
    static constexpr std::int64_t kCast = 2048;
    std::int64_t left_ = 0;
};

/// What each dab prints.
struct Brush {
    const ImagePyramid* picture = nullptr;  // either this...
    RoundTips* round_tips = nullptr;        // ...or these, which are masks
    bool is_mask = false;                   // the picture's alpha in `color`, as against its own colours
    Float4 color{};                         // sRGB and straight alpha, 0 to 1
    float flow = 1.0f;
};

/// Lays dabs [first, end) over `tiles`, which hold those before, and marks the tiles that they change in `dirty_tiles`
/// (one byte a tile of the map). `cast` without a projector. `out_texels`: how many texels took colour, dab by dab. Ends early
/// where `work_left` does; `first` is then the dab to go on with. Errors: OUT_OF_BUDGET; `tiles` may then hold some of the dabs.
TxcStatus paint_dabs(const CastScene& scene, PictureCast cast, const Brush& brush, const std::vector<TxcDab>& dabs,
                     std::size_t& first, LayerTiles& tiles, std::vector<std::uint8_t>& dirty_tiles, WorkLeft& work_left,
                     std::uint64_t& out_texels);

/// Empties tiles and gives their memory back.
void release_tiles(LayerTiles& tiles);

}  // namespace txc
