// No seam shows on a sphere of several charts, at any mip level: its texture is painted, exported, made smaller level by
// level and looked at as a graphics card does, along both sides of every border (spec sections 2 and 6).
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "bleed.h"
#include "gutter.h"
#include "mip_chain.h"
#include "support/test_session.h"

using namespace support;

namespace {

constexpr std::uint32_t kSide = 512;
constexpr std::uint32_t kGores = 4;
/// Degrees about the globe's axis.
constexpr double kTurned = 17;
/// Points along a border: closer than the texels of the finest level.
constexpr std::uint32_t kSteps = 600;

/// Eight charts, four to the north and four to the south, in cells of the texture.
struct Globe {
    /// Cells of 1/4 x 1/2 of `share` of the texture, the charts `margin` texels within them; beyond is nothing.
    Globe(double share, double margin) {
        const double edge = margin / kSide;
        for (std::uint32_t half = 0; half < 2; ++half) {
            for (std::uint32_t gore = 0; gore < kGores; ++gore) {
                charts[half][gore] = {share * gore / kGores + edge, share * half / 2 + edge,
                                      share * (gore + 1) / kGores - edge, share * (half + 1) / 2 - edge};
                shape.append(
                    make_grid(24, 24, charts[half][gore], [&](double s, double t, double(&p)[3], double(&n)[3]) {
                        const std::array<double, 3> at = place(gore + s, half + t);
                        for (std::size_t c = 0; c < 3; ++c) p[c] = n[c] = at[c];
                    }));
            }
        }
    }

    /// A point of the unit sphere: gores round it, halves from the north pole down.
    static std::array<double, 3> place(double gores, double halves) {
        const double around = gores * 2 * kPi / kGores;
        const double down = halves * kPi / 2;
        return {-std::sin(around) * std::sin(down), std::cos(down), -std::cos(around) * std::sin(down)};
    }

    /// Texels of a chart's shorter side at a level.
    double chart_texels(std::uint32_t level) const {
        const UvRect& chart = charts[0][0];
        return std::min(chart.right - chart.left, chart.bottom - chart.top) * kSide / (1u << level);
    }

    /// Calls visit(position, u0, v0, u1, v1) for points of all borders: one place of the sphere in both charts.
    template <typename Visit>
    void along_borders(Visit&& visit) const {
        for (std::uint32_t step = 0; step <= kSteps; ++step) {
            const double t = static_cast<double>(step) / kSteps;
            for (std::uint32_t gore = 0; gore < kGores; ++gore) {
                for (std::uint32_t half = 0; half < 2; ++half) {
                    const UvRect& here = charts[half][gore];
                    const UvRect& next = charts[half][(gore + 1) % kGores];
                    const double v = here.top + (here.bottom - here.top) * t;
                    visit(place(gore + 1, half + t), here.right, v, next.left, v);
                }
                const UvRect& north = charts[0][gore];
                const UvRect& south = charts[1][gore];
                const double u = north.left + (north.right - north.left) * t;
                visit(place(gore + t, 1), u, north.bottom, u, south.top);
            }
        }
    }

    /// Calls visit(u, v) for points of all charts, their borders too.
    template <typename Visit>
    void all_over(Visit&& visit) const {
        for (const auto& row : charts) {
            for (const UvRect& chart : row) {
                for (std::uint32_t y = 0; y <= 100; ++y) {
                    for (std::uint32_t x = 0; x <= 100; ++x)
                        visit(chart.left + (chart.right - chart.left) * x / 100,
                              chart.top + (chart.bottom - chart.top) * y / 100);
                }
            }
        }
    }

    Shape shape;
    UvRect charts[2][kGores];
};

/// What is looked at: the texture as it is, made smaller without knowing of charts; as it is exported, likewise; or the
/// core's own levels, as the page shows them.
enum class Levels { plain, exported, live };

/// One painted globe's texture with all its levels.
struct Painted {
    Painted(const Globe& globe, const Picture& decal, std::uint32_t gutter, Levels which) : session(globe.shape) {
        const TxcTarget target = session.target(kSide, kSide, gutter, 0);
        session.set_base(target, Color{255, 255, 255, 255});
        TxcLayerDef def = decal_def(session.image(decal));
        // Through the whole globe, whichever way its surface looks; turned, so that no border lies where it is grazed.
        resize(def, 2.2, 2.2, 2.2);
        turn(def, 0.0, 1.0, 0.0, kTurned);
        def.backfaces = 1;
        def.angle_fade_start = def.angle_fade_end = 90;
        def.occlusion = TXC_OCCLUSION_NONE;
        session.layer(target, def);
        session.update(target);
        mips.allocate(kSide, kSide, txc::MipChain::full_count(kSide, kSide));
        mips.levels[0].rgba = session.read(target).rgba;
        if (which == Levels::exported)
            must(txc_target_read_bled(session.id(), target, 0, kSide, mips.levels[0].rgba.data()));
        for (std::uint32_t level = 1; level < mips.levels.size(); ++level) {
            txc::MipLevel& mip = mips.levels[level];
            if (which == Levels::live) {
                mip.rgba = session.read(target, level).rgba;
            } else {
                mips.reduce(level, 0, 0, mip.width, mip.height);
            }
        }
    }

    /// As a graphics card samples one level: bilinear, repeating.
    std::array<double, 3> sample(std::uint32_t level, double u, double v) const {
        const txc::MipLevel& mip = mips.levels[level];
        const double x = u * mip.width - 0.5;
        const double y = v * mip.height - 0.5;
        const double left = std::floor(x);
        const double top = std::floor(y);
        std::array<double, 3> color{};
        for (int dy = 0; dy < 2; ++dy) {
            for (int dx = 0; dx < 2; ++dx) {
                const double weight = (dx == 0 ? 1 - (x - left) : x - left) * (dy == 0 ? 1 - (y - top) : y - top);
                const auto wrapped = [](double at, std::uint32_t size) {
                    const auto whole = static_cast<std::int64_t>(at);
                    return static_cast<std::size_t>((whole + size) % size);
                };
                const std::size_t texel = wrapped(top + dy, mip.height) * mip.width + wrapped(left + dx, mip.width);
                for (std::size_t c = 0; c < 3; ++c) color[c] += weight * mip.rgba[texel * 4 + c];
            }
        }
        return color;
    }

    TestSession session;
    txc::MipChain mips;
};

double farthest(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    double most = 0;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::fabs(a[c] - b[c]));
    return most;
}

/// The gradient's colour at a place of the unit sphere.
std::array<double, 3> gradient_at(const std::array<double, 3>& p) {
    const double angle = kTurned * kPi / 180;
    const double right = (p[0] * std::cos(angle) - p[2] * std::sin(angle)) / 2.2 + 0.5;
    const double down = 0.5 - p[1] / 2.2;
    return {255 * right, 255 * down, 255 - 255 * right};
}

/// How far the colours beside the borders lie from the gradient's own (`off`) and from each other (`step`), of 255.
struct Seam {
    double off = 0;
    double step = 0;
};
Seam widest_seam(const Globe& globe, const Painted& painted, std::uint32_t level) {
    Seam seam;
    globe.along_borders([&](const std::array<double, 3>& at, double u0, double v0, double u1, double v1) {
        const auto here = painted.sample(level, u0, v0);
        const auto there = painted.sample(level, u1, v1);
        const auto expected = gradient_at(at);
        seam.off = std::max({seam.off, farthest(here, expected), farthest(there, expected)});
        seam.step = std::max(seam.step, farthest(here, there));
    });
    return seam;
}

/// How much the gradient changes over a texel of a level, of 255: the steepest is a quarter of the equator in a chart.
double slope_of(const Globe& globe, std::uint32_t level) { return 255 / 2.2 * (kPi / 2) / globe.chart_texels(level); }

const Color kPaint{200, 30, 90, 255};
/// Of the weights in a sample, of 255.
constexpr double kRounding = 1e-9;

/// The farthest that any point of the globe lies from the colour that it was painted in.
double widest_stain(const Globe& globe, const Painted& painted, std::uint32_t level) {
    double widest = 0;
    const auto look = [&](double u, double v) {
        widest = std::max(widest, farthest(painted.sample(level, u, v), {200, 30, 90}));
    };
    globe.all_over(look);
    globe.along_borders([&](const std::array<double, 3>&, double u0, double v0, double u1, double v1) {
        look(u0, v0);
        look(u1, v1);
    });
    return widest;
}

}  // namespace

TEST_CASE("A sphere painted in one colour shows that colour alone, at every level and on every border") {
    const Globe globe(1.0, 9.0);
    const Painted painted(globe, Picture(256, 256, kPaint), TXC_NONE, Levels::exported);
    for (std::uint32_t level = 0; globe.chart_texels(level) >= 1; ++level) {
        CAPTURE(level);
        CHECK(widest_stain(globe, painted, level) < kRounding);
    }
}

TEST_CASE("A gradient round a sphere is off on no border by more than it changes over a texel of the level") {
    const Globe globe(1.0, 9.0);
    const Painted painted(globe, make_gradient(256, 256), TXC_NONE, Levels::exported);
    for (std::uint32_t level = 0; globe.chart_texels(level) >= 1; ++level) {
        CAPTURE(level);
        const Seam seam = widest_seam(globe, painted, level);
        CHECK(seam.off <= slope_of(globe, level));
        CHECK(seam.step <= std::max(1.0, slope_of(globe, level) / 2));
    }
}

TEST_CASE("Beside wide empty room no seam shows while a texel and a half of the level fits in what bled") {
    const Globe globe(0.5, 5.0);
    const Painted plain(globe, Picture(256, 256, kPaint), TXC_NONE, Levels::exported);
    const Painted gradient(globe, make_gradient(256, 256), TXC_NONE, Levels::exported);
    const double reach = txc::default_gutter(kSide, kSide) + txc::bleed_reach(kSide, kSide);
    std::uint32_t level = 0;
    for (; 1.5 * (1u << level) <= reach; ++level) {
        CAPTURE(level);
        CHECK(widest_stain(globe, plain, level) < kRounding);
        CHECK(widest_seam(globe, gradient, level).off <= slope_of(globe, level));
    }
    CHECK(level == 4);
}

TEST_CASE("The core's own levels keep the ground from between the charts to a faint trace, and off the finest two") {
    const Globe globe(1.0, 9.0);
    const Painted plain(globe, Picture(256, 256, kPaint), TXC_NONE, Levels::live);
    const Painted gradient(globe, make_gradient(256, 256), TXC_NONE, Levels::live);
    // The ground is as far as 225 from the paint. A sample may reach half a texel of its level beyond a border, where the
    // gutter is narrower than that: a corner of the ground then shows through.
    const double trace = 225.0 / 6;
    for (std::uint32_t level = 0; globe.chart_texels(level) >= 1; ++level) {
        CAPTURE(level);
        CHECK(widest_stain(globe, plain, level) <= (level < 2 ? kRounding : trace));
        CHECK(widest_seam(globe, gradient, level).off <= slope_of(globe, level) + (level < 2 ? 0.0 : trace));
    }
}

TEST_CASE("Without gutter and bleeding the ground shows through every border: these tests would see it") {
    const Globe globe(1.0, 9.0);
    const Painted plain(globe, Picture(256, 256, kPaint), 0, Levels::plain);
    const Painted gradient(globe, make_gradient(256, 256), 0, Levels::plain);
    // The gutter alone is enough for the finest two levels.
    const Painted guttered(globe, Picture(256, 256, kPaint), TXC_NONE, Levels::plain);
    for (std::uint32_t level = 0; globe.chart_texels(level) >= 1; ++level) {
        CAPTURE(level);
        CHECK(widest_stain(globe, plain, level) > 100);
        CHECK(widest_seam(globe, gradient, level).off > slope_of(globe, level));
        CHECK((widest_stain(globe, guttered, level) < kRounding) == (level < 2));
    }
}
