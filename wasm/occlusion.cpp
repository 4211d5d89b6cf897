#include "occlusion.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "ray_space.h"

namespace txc {
namespace {

constexpr std::uint32_t kLeafSize = 4;
constexpr int kBins = 16;
// Made-up triangles can drive the splits into a chain; below this depth nodes are simply halved, which bounds the tree.
constexpr int kMaxSahDepth = 48;
constexpr double kLeastDistanceShare = 0.0005;
// More triangles than these near a bundle of rays, and its halves are asked for. (64 take as long on a mug, and on 200,000 triangles and
// on a figure of many shells as long as no bundles do; 600 take as long as 256.)
constexpr std::size_t kMostNear = 256;

/// A box of triangles; of none, inside out.
struct ItemBox {
    Float4 low = splat(std::numeric_limits<float>::infinity());
    Float4 high = -low;

    void add(Float4 other_low, Float4 other_high) {
        low = lesser(low, other_low);
        high = greater(high, other_high);
    }
    double half_area() const {
        const double x = static_cast<double>(high[0]) - static_cast<double>(low[0]);
        const double y = static_cast<double>(high[1]) - static_cast<double>(low[1]);
        const double z = static_cast<double>(high[2]) - static_cast<double>(low[2]);
        return x * y + y * z + z * x;
    }
    glm::vec3 min() const { return {low[0], low[1], low[2]}; }
    glm::vec3 max() const { return {high[0], high[1], high[2]}; }
};

}  // namespace

TxcStatus OcclusionTree::build(const Mesh& mesh) {
    mesh_ = &mesh;
    const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
    // Nodes and order stay; items are scratch.
    if (const TxcStatus status = share_.resize(
            static_cast<std::uint64_t>(count) * (2 * sizeof(Node) + 4 + sizeof(Item)), "the occlusion tree");
        status != TXC_STATUS_OK)
        return status;
    std::vector<Item> items(count);
    ItemBox all;
    for (std::uint32_t t = 0; t < count; ++t) {
        ItemBox box;
        for (const std::uint32_t v : mesh.triangles[t].vertex) {
            const Float4 corner = load_vec3(mesh.positions[v]);
            box.add(corner, corner);
        }
        all.add(box.low, box.high);
        Int4 low_bits = reinterpret_cast<Int4>(box.low);
        low_bits[3] = static_cast<std::int32_t>(t);
        items[t] = {reinterpret_cast<Float4>(low_bits), box.high};
    }
    least_distance_ = static_cast<double>(count > 0 ? glm::length(all.max() - all.min()) : 0.0f) * kLeastDistanceShare;
    nodes_.clear();
    nodes_.reserve(static_cast<std::size_t>(count) * 2);
    nodes_.push_back({all.min(), 0, all.max(), count});
    struct Open {
        std::uint32_t node;
        int depth;
    };
    std::vector<Open> open{{0, 0}};
    while (!open.empty()) {
        const Open next = open.back();
        open.pop_back();
        split(next.node, next.depth >= kMaxSahDepth, items);
        if (nodes_[next.node].count == 0) {
            open.push_back({nodes_[next.node].first + 1, next.depth + 1});
            open.push_back({nodes_[next.node].first, next.depth + 1});
        }
    }
    nodes_.shrink_to_fit();
    order_.resize(count);
    for (std::uint32_t i = 0; i < count; ++i)
        order_[i] = static_cast<std::uint32_t>(reinterpret_cast<Int4>(items[i].low)[3]);
    return share_.resize(nodes_.size() * sizeof(Node) + order_.size() * 4, "the occlusion tree");
}

void OcclusionTree::split(std::uint32_t node_index, bool in_halves, std::vector<Item>& items) {
    const std::uint32_t first = nodes_[node_index].first;
    const std::uint32_t count = nodes_[node_index].count;
    if (count <= kLeafSize) return;
    Item* const begin = items.data() + first;
    Item* const end = begin + count;
    // Twice their middles: halved, small ones would be rounded.
    ItemBox middle;
    for (const Item* item = begin; item != end; ++item) middle.add(item->low + item->high, item->low + item->high);
    const Float4 extents = middle.high - middle.low;
    const int axis = extents[0] >= extents[1] ? (extents[0] >= extents[2] ? 0 : 2) : (extents[1] >= extents[2] ? 1 : 2);
    const float low = middle.low[axis];
    const float extent = extents[axis];
    const auto bin_of = [&](const Item& item) {
        return std::min(kBins - 1, static_cast<int>((item.low[axis] + item.high[axis] - low) / extent * kBins));
    };
    Item* cut = begin + count / 2;
    if (extent > 0.0f && !in_halves) {
        ItemBox bins[kBins];
        std::uint32_t counts[kBins] = {};
        for (const Item* item = begin; item != end; ++item) {
            const int bin = bin_of(*item);
            bins[bin].add(item->low, item->high);
            ++counts[bin];
        }
        ItemBox right_boxes[kBins];
        ItemBox right;
        for (int bin = kBins - 1; bin > 0; --bin) {
            right.add(bins[bin].low, bins[bin].high);
            right_boxes[bin] = right;
        }
        // The first bin and the last hold the outermost middles, so there are some on either side of each cut.
        double best_cost = 1e300;
        int best_bin = 1;
        ItemBox left;
        std::uint32_t left_count = 0;
        for (int bin = 1; bin < kBins; ++bin) {
            left.add(bins[bin - 1].low, bins[bin - 1].high);
            left_count += counts[bin - 1];
            const double cost = left.half_area() * left_count + right_boxes[bin].half_area() * (count - left_count);
            if (cost < best_cost) {
                best_cost = cost;
                best_bin = bin;
            }
        }
        cut = std::partition(begin, end, [&](const Item& item) { return bin_of(item) < best_bin; });
    }
    const auto left_count = static_cast<std::uint32_t>(cut - begin);
    Node children[2] = {{{}, first, {}, left_count}, {{}, first + left_count, {}, count - left_count}};
    for (Node& child : children) {
        ItemBox box;
        for (const Item* item = items.data() + child.first; item != items.data() + child.first + child.count; ++item)
            box.add(item->low, item->high);
        child.min = box.min();
        child.max = box.max();
    }
    nodes_[node_index].first = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node_index].count = 0;
    nodes_.push_back(children[0]);
    nodes_.push_back(children[1]);
}

// Möller and Trumbore, "Fast, minimum storage ray/triangle intersection" (1997), both sides.
bool OcclusionTree::is_met(const TexelRay& ray) const {
    for (NearTriangle& t : near_) {
        const glm::dvec3 p = glm::cross(ray.direction, t.ac);
        const double determinant = glm::dot(t.ab, p);
        if (determinant == 0.0 || t.index == ray.own) continue;
        const glm::dvec3 from_a = ray.origin - t.a;
        const double u = glm::dot(from_a, p) / determinant;
        if (!(u >= 0.0 && u <= 1.0)) continue;
        const glm::dvec3 q = glm::cross(from_a, t.ab);
        const double v = glm::dot(ray.direction, q) / determinant;
        if (!(v >= 0.0 && u + v <= 1.0)) continue;
        const double distance = glm::dot(t.ac, q) / determinant;
        if (distance > least_distance_ && distance <= ray.length) {
            // What blocks one ray is likely to block the next.
            std::swap(t, near_.front());
            return true;
        }
    }
    return false;
}

/// The triangles of leaves that, as all nodes above them, the test is true for.
template <typename Test>
void OcclusionTree::gather(std::vector<std::uint32_t>& out, Test&& test) const {
    out.clear();
    std::uint32_t stack[kMaxSahDepth + 34];  // one a level, and halving 2^32 triangles takes 32 levels
    std::uint32_t depth = nodes_.empty() ? 0 : 1;
    stack[0] = 0;
    while (depth > 0) {
        const Node& node = nodes_[stack[--depth]];
        if (!test(node)) continue;
        if (node.count == 0) {
            stack[depth++] = node.first + 1;
            stack[depth++] = node.first;
        } else {
            out.insert(out.end(), order_.begin() + node.first, order_.begin() + node.first + node.count);
        }
    }
}

bool OcclusionTree::is_blocked(const TexelRay& ray) const {
    find_near(&ray, &ray + 1);
    return is_met(ray);
}

void OcclusionTree::find_near(const TexelRay* begin, const TexelRay* end) const {
    // Boxes of beginnings and ends, and what lies between: a box as large as either that goes from the one to the other.
    glm::dvec3 first(0.0);
    glm::dvec3 reach(0.0);
    glm::dvec3 inverse(0.0);  // of the way
    for (int axis = 0; axis < 3; ++axis) {
        double low[2] = {begin->origin[axis], begin->origin[axis] + begin->direction[axis] * begin->length};
        double high[2] = {low[0], low[1]};
        for (const TexelRay* ray = begin; ray != end; ++ray) {
            const double ends[2] = {ray->origin[axis], ray->origin[axis] + ray->direction[axis] * ray->length};
            for (int i = 0; i < 2; ++i) {
                low[i] = std::min(low[i], ends[i]);
                high[i] = std::max(high[i], ends[i]);
            }
        }
        first[axis] = (low[0] + high[0]) * 0.5;
        // Slack for the rounding of the two sides: a flat box must not fall between them.
        reach[axis] = std::max(high[0] - low[0], high[1] - low[1]) * 0.5 + least_distance_ * 1e-3;
        // Bounded: along an axis that the way does not move on, a box that begins at it would give NaN, and be passed by.
        inverse[axis] = std::clamp(1.0 / ((low[1] + high[1]) * 0.5 - first[axis]), -1e300, 1e300);
    }
    gather(found_, [&](const Node& node) {
        double enter = 0.0;
        double leave = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            const double from = (static_cast<double>(node.min[axis]) - reach[axis] - first[axis]) * inverse[axis];
            const double to = (static_cast<double>(node.max[axis]) + reach[axis] - first[axis]) * inverse[axis];
            // (fmin and fmax do the same, but are calls: a third of a ray's time.)
            const bool ascends = from < to;
            const double nearer = ascends ? from : to;
            const double further = ascends ? to : from;
            if (nearer > enter) enter = nearer;
            if (further < leave) leave = further;
        }
        return enter <= leave;
    });
    keep_near(begin, end);
}

void OcclusionTree::keep_near(const TexelRay* begin, const TexelRay* end) const {
    const auto corner = [&](std::uint32_t triangle, int i) {
        return glm::dvec3(mesh_->positions[mesh_->triangles[triangle].vertex[i]]);
    };
    glm::dvec3 up(0.0);
    double ground = -1e300;  // a lone ray is not worth the asking
    if (end - begin > 1) {
        const TexelRay& middle = begin[(end - begin) / 2];
        const glm::dvec3 origin = corner(middle.own, 0);
        up = glm::cross(corner(middle.own, 1) - origin, corner(middle.own, 2) - origin);
        if (glm::dot(up, middle.direction) < 0.0) up = -up;
        double lowest = 1e300;
        double rise = 1e300;
        for (const TexelRay* ray = begin; ray != end; ++ray) {
            lowest = std::min(lowest, glm::dot(up, ray->origin));
            rise = std::min(rise, glm::dot(up, ray->direction));
        }
        // A little lower, for rounding. Where a ray goes down there is no ground.
        if (rise > 0.0) ground = lowest + rise * least_distance_ * 0.999;
    }
    near_.clear();
    for (const std::uint32_t t : found_) {
        const glm::dvec3 a = corner(t, 0);
        const glm::dvec3 b = corner(t, 1);
        const glm::dvec3 c = corner(t, 2);
        if (std::max(glm::dot(up, a), std::max(glm::dot(up, b), glm::dot(up, c))) >= ground)
            near_.push_back({a, b - a, c - a, t});
        // These rays are asked for by halves.
        if (near_.size() > kMostNear && end - begin > 1) return;
    }
}

void OcclusionTree::clear_blocked(const TexelRay* begin, const TexelRay* end) const {
    find_near(begin, end);
    if (near_.size() > kMostNear && end - begin > 1) {
        const TexelRay* const middle = begin + (end - begin) / 2;
        clear_blocked(begin, middle);
        clear_blocked(middle, end);
        return;
    }
    for (; begin != end; ++begin) {
        if (is_met(*begin)) std::memset(begin->texel, 0, 4 * sizeof *begin->texel);
    }
}

void OcclusionTree::find(const RaySpace& space, std::vector<std::uint32_t>& out) const {
    gather(out, [&](const Node& node) { return space.may_touch({node.min, node.max}); });
}

glm::dvec3 nearest_point_on_triangle(const Mesh& mesh, std::uint32_t triangle, const glm::dvec3& point) {
    // After Ericson, "Real-Time Collision Detection" (2005), section 5.1.5: which of the seven regions holds the point.
    const Triangle& corners = mesh.triangles[triangle];
    const glm::dvec3 a(mesh.positions[corners.vertex[0]]);
    const glm::dvec3 b(mesh.positions[corners.vertex[1]]);
    const glm::dvec3 c(mesh.positions[corners.vertex[2]]);
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const glm::dvec3 ap = point - a;
    const double d1 = glm::dot(ab, ap);
    const double d2 = glm::dot(ac, ap);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const glm::dvec3 bp = point - b;
    const double d3 = glm::dot(ab, bp);
    const double d4 = glm::dot(ac, bp);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + ab * (d1 / (d1 - d3));
    const glm::dvec3 cp = point - c;
    const double d5 = glm::dot(ab, cp);
    const double d6 = glm::dot(ac, cp);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + ac * (d2 / (d2 - d6));
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    const double sum = va + vb + vc;
    if (!(sum > 0.0)) return a;
    return a + ab * (vb / sum) + ac * (vc / sum);
}

}  // namespace txc
