// The kernels, written once. Included by one source per instruction set, in an anonymous namespace.

/// Largest relative difference of neighbouring leaflet points that still counts as apart, mm2.
template <class R>
constexpr R kTiny_mm2 = R(1e-20);
constexpr double kLeastStiffness_n_per_mm = 1e-3;  // of a node that nothing holds

template <class R>
using Quad4 = typename Registers<R>::Quad4;
template <class R>
COAPT_INLINE Quad4<R> load_quad(const Quad<R>& quad) {
  Quad4<R> result;
  __builtin_memcpy(&result, &quad.at, sizeof result);
  return result;
}
template <class R>
COAPT_INLINE void add_quad(const typename Registers<R>::Quad4& more, Quad<R>& quad) {
  const Quad4<R> sum = load_quad(quad) + more;
  __builtin_memcpy(&quad.at, &sum, sizeof sum);
}

/// Adds force `f` with `stiffness` to node 0 of the active lanes and what balances it to the others.
template <class R>
COAPT_INLINE void scatter(const IndexLane* node, unsigned active, const Vec3x<R>& f,
                          const Vec<R>& stiffness, const Vec<R>* weight, int weights,
                          Quad<R>* force) {
  Quad<R> quads[kLanes];
  Lane<R> share[3];
  store_quads(Vec4x<R>{f.x, f.y, f.z, stiffness}, quads);
  for (int k = 0; k < weights; ++k) store(weight[k], share[k]);
  const Quad4<R> against = {-1, -1, -1, 1};
  for (; active != 0; active &= active - 1) {
    const int lane = __builtin_ctz(active);
    Quad4<R> q = load_quad(quads[lane]);
    add_quad(q, force[node[0].at[lane]]);
    q *= against;
    for (int k = 0; k < weights; ++k) add_quad(q * share[k].at[lane], force[node[k + 1].at[lane]]);
  }
}

template <class R>
void pull_cables(const CableBlock<R>* cables, int blocks, const Quad<R>* x, Quad<R>* force) {
  for (int b = 0; b < blocks; ++b) {
    const CableBlock<R>& c = cables[b];
    const Vec<R> w[3] = {load(c.weight[0]), load(c.weight[1]), load(c.weight[2])};
    const Vec3x<R> end = w[0] * xyz(gather(x, c.node[1])) + w[1] * xyz(gather(x, c.node[2])) +
                         w[2] * xyz(gather(x, c.node[3]));
    const Vec3x<R> d = end - xyz(gather(x, c.node[0]));
    const Vec<R> stiffness = load(c.stiffness_n_per_mm);
    const Vec<R> length2 = dot(d, d) + all(kTiny_mm2<R>);
    const Vec<R> inverse = inverse_sqrt(length2);
    const Vec<R> stretch = largest(length2 * inverse - load(c.rest_mm), all(R(0)));
    // A slack cable weighs as much as a taut one: else its end rattles between the two.
    scatter(c.node, bits(all(R(0)) < stiffness), (stiffness * stretch * inverse) * d, stiffness, w,
            3, force);
  }
}

template <class R>
StepSums advance(const StepInput<R>& in) {
  const Vec<R> zero = all(R(0)), one = all(R(1));
  const Vec<R> least_stiffness = all(static_cast<R>(kLeastStiffness_n_per_mm));
  const Vec<R> per_mass = all(R(1) / in.mass_share);
  const Vec<R> longest2 = all(in.longest_move_mm * in.longest_move_mm);
  Vec<R> force2 = zero, pressure2 = zero, move2 = zero, from_list2 = zero;
  for (int b = 0; b < in.block_count; ++b) {
    NodeBlock<R>& block = in.blocks[b];
    const Vec3x<R> x = xyz(load_quads(in.x + kLanes * b));
    const Vec4x<R> pushed = load_quads(in.force + kLanes * b);
    store_quads(Vec4x<R>{zero, zero, zero, zero}, in.force + kLanes * b);
    Vec3x<R> elastic = {zero, zero, zero}, pressure = elastic, before = elastic;
    Vec<R> stiffness = pushed.w;
    for (int s = 0; s < block.slots; ++s) {
      const FanSlot<R>& slot = in.slots[block.first_slot + s];
      const Vec3x<R> d = xyz(gather(in.x, slot.neighbour)) - x;
      const Vec<R> length2 = dot(d, d) + all(kTiny_mm2<R>);
      const Vec<R> inverse = inverse_sqrt(length2);
      const Vec<R> length = length2 * inverse;
      const Vec<R> knee = load(slot.knee_mm), pre = load(slot.pre_n_per_mm),
                   extra = load(slot.extra_n_per_mm), load_mpa = load(slot.load_mpa);
      const Vec<R> pull =
          (pre * (length - load(slot.rest_mm)) + extra * largest(length - knee, zero)) * inverse;
      elastic = elastic + pull * d;
      pressure = pressure + load_mpa * cross(before, d);
      before = d;
      const Vec<R> tangent = pre + select(knee < length + all(in.lookahead_mm), extra, zero);
      stiffness = stiffness + largest(tangent, magnitude(pull)) + (load_mpa + load_mpa) * length;
    }
    const Vec<R> free = load(block.free);
    const Vec3x<R> force = free * (elastic + pressure + xyz(pushed));
    force2 = force2 + dot(force, force);
    pressure2 = pressure2 + free * dot(pressure, pressure);
    // Mass goes with stiffness. A node that becomes heavier keeps its momentum, not its speed: else the
    // knee of the springs would feed it energy.
    const Vec<R> held = largest(stiffness, least_stiffness);
    const Vec<R> inverse = one / held;
    const Vec<R> keep = all(in.keep) * least(one, load(block.stiffness) * inverse);
    store(held, block.stiffness);
    const Vec3x<R> old = {load(block.velocity[0]), load(block.velocity[1]),
                          load(block.velocity[2])};
    Vec3x<R> v = keep * old + (inverse * per_mass) * force;
    const Vec<R> v2 = dot(v, v);
    const Vec<R> shorten =
        select(longest2 < v2, all(in.longest_move_mm) * inverse_sqrt(largest(v2, longest2)), one);
    v = shorten * v;
    move2 = largest(least(v2, longest2), move2);
    store(v.x, block.velocity[0]), store(v.y, block.velocity[1]), store(v.z, block.velocity[2]);
    const Vec3x<R> next = x + v;
    store_quads(Vec4x<R>{next.x, next.y, next.z, zero}, in.next + kLanes * b);
    const Vec3x<R> moved = next - Vec3x<R>{load(block.listed_at[0]), load(block.listed_at[1]),
                                           load(block.listed_at[2])};
    from_list2 = largest(free * dot(moved, moved), from_list2);
  }
  return {sum(force2), sum(pressure2), static_cast<double>(largest_of(move2)),
          static_cast<double>(largest_of(from_list2))};
}

/// Contact force and its stiffness of pairs whose features are `d` apart.
template <class R>
struct Push {
  unsigned active;
  Vec3x<R> force;
  Vec<R> stiffness;
};
template <class R>
COAPT_INLINE Push<R> push(PairBlock<R>& pairs, R approach_mm, const Vec3x<R>& d) {
  const Vec<R> thickness = load(pairs.thickness_mm), law = load(pairs.force_n_per_mm2);
  const Vec<R> distance2 = dot(d, d);
  const Mask<R> near =
      (distance2 < thickness * magnitude(thickness)) & (all(kTiny_mm2<R>) < distance2);
  const Vec<R> inverse = inverse_sqrt(largest(distance2, all(kTiny_mm2<R>)));
  const unsigned active = bits(near);
  if (active == 0) {
    pairs.asleep_until_mm = approach_mm + least_of(distance2 * inverse - thickness);
    return {0, d, thickness};
  }
  const Vec<R> gap = largest(thickness - distance2 * inverse, all(R(0)));
  const Vec<R> per_mm = law * gap * gap * inverse;
  return {active, per_mm * d, largest(all(R(2)) * law * gap, per_mm)};
}

/// How the features of sixteen pairs lie: from the nearest point of the second to that of the first,
/// and the weights of those points on their nodes.
template <class R>
struct FaceApart {
  Vec3x<R> d;
  Vec<R> wb, wc;  ///< on the face's second and third node
};
template <class R>
COAPT_INLINE FaceApart<R> face_apart(const IndexLane* node, const Quad<R>* x) {
  const Vec<R> zero = all(R(0)), one = all(R(1));
  const Vec3x<R> p = xyz(gather(x, node[0])), a = xyz(gather(x, node[1]));
  const Vec3x<R> ab = xyz(gather(x, node[2])) - a, ac = xyz(gather(x, node[3])) - a;
  const Vec3x<R> ap = p - a;
  // Ericson 2005, 5.1.5, all regions at once: weights of b and c as fractions of one denominator.
  const Vec<R> ab2 = dot(ab, ab), ac2 = dot(ac, ac), bc = dot(ab, ac);
  const Vec<R> d1 = dot(ab, ap), d2 = dot(ac, ap);
  const Vec<R> d3 = d1 - ab2, d4 = d2 - bc, d5 = d1 - bc, d6 = d2 - ac2;
  const Vec<R> va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  const Vec<R> along_bc = d4 - d3, back_bc = d5 - d6;
  Vec<R> wb = vb, wc = vc, whole = va + vb + vc;
  const auto in_case = [&](const Mask<R>& mask, const Vec<R>& b_part, const Vec<R>& c_part,
                           const Vec<R>& denominator) {
    wb = select(mask, b_part, wb);
    wc = select(mask, c_part, wc);
    whole = select(mask, denominator, whole);
  };
  in_case((va <= zero) & (zero <= along_bc) & (zero <= back_bc), back_bc, along_bc,
          along_bc + back_bc);
  in_case((vb <= zero) & (zero <= d2) & (d6 <= zero), zero, d2, d2 - d6);
  in_case((zero <= d6) & (d5 <= d6), zero, one, one);
  in_case((vc <= zero) & (zero <= d1) & (d3 <= zero), d1, zero, d1 - d3);
  in_case((zero <= d3) & (d4 <= d3), one, zero, one);
  in_case((d1 <= zero) & (d2 <= zero), zero, zero, one);
  const Vec<R> inverse = one / whole;
  wb = wb * inverse, wc = wc * inverse;
  return {ap - wb * ab - wc * ac, wb, wc};
}

template <class R>
struct EdgesApart {
  Vec3x<R> d;
  Vec<R> s, t;  ///< share of the way along the first and the second edge
};
template <class R>
COAPT_INLINE EdgesApart<R> edges_apart(const IndexLane* node, const Quad<R>* x) {
  const Vec<R> zero = all(R(0)), one = all(R(1));
  const auto clamp = [&](const Vec<R>& v) { return largest(zero, least(one, v)); };
  const Vec3x<R> a = xyz(gather(x, node[0])), c = xyz(gather(x, node[2]));
  const Vec3x<R> ab = xyz(gather(x, node[1])) - a, cd = xyz(gather(x, node[3])) - c;
  const Vec3x<R> ca = a - c;
  // Ericson 2005, 5.1.9.
  const Vec<R> ab2 = largest(dot(ab, ab), all(kTiny_mm2<R>)),
               cd2 = largest(dot(cd, cd), all(kTiny_mm2<R>));
  const Vec<R> mixed = dot(ab, cd), along_ab = dot(ab, ca), along_cd = dot(cd, ca);
  const Vec<R> square = ab2 * cd2, determinant = square - mixed * mixed;
  const Mask<R> skew = all(R(1e-6)) * square < determinant;
  const Vec<R> on_line = (mixed * along_cd - along_ab * cd2) / select(skew, determinant, one);
  const Vec<R> s = select(skew, clamp(on_line), zero);
  const Vec<R> free_t = (mixed * s + along_cd) / cd2;
  const Vec<R> t = clamp(free_t);
  const Vec<R> beside = clamp((mixed * t - along_ab) / ab2);
  const Vec<R> at = select(free_t < zero, beside, select(one < free_t, beside, s));
  return {ca + at * ab - t * cd, at, t};
}

template <class R>
void push_faces(PairBlock<R>* blocks, int count, R approach_mm, const Quad<R>* x, Quad<R>* force) {
  for (int b = 0; b < count; ++b) {
    PairBlock<R>& pairs = blocks[b];
    if (approach_mm < pairs.asleep_until_mm) continue;
    const FaceApart<R> apart = face_apart(pairs.node, x);
    const Push<R> pushed = push(pairs, approach_mm, apart.d);
    if (pushed.active == 0) continue;
    const Vec<R> weight[3] = {all(R(1)) - apart.wb - apart.wc, apart.wb, apart.wc};
    scatter(pairs.node, pushed.active, pushed.force, pushed.stiffness, weight, 3, force);
  }
}

template <class R>
void push_edges(PairBlock<R>* blocks, int count, R approach_mm, const Quad<R>* x, Quad<R>* force) {
  for (int i = 0; i < count; ++i) {
    PairBlock<R>& pairs = blocks[i];
    if (approach_mm < pairs.asleep_until_mm) continue;
    const EdgesApart<R> apart = edges_apart(pairs.node, x);
    const Push<R> pushed = push(pairs, approach_mm, apart.d);
    if (pushed.active == 0) continue;
    // Like scatter, but both features have weights.
    Quad<R> quads[kLanes];
    Lane<R> first, second;
    store_quads(Vec4x<R>{pushed.force.x, pushed.force.y, pushed.force.z, pushed.stiffness}, quads);
    store(apart.s, first), store(apart.t, second);
    const Quad4<R> against = {-1, -1, -1, 1};
    for (unsigned active = pushed.active; active != 0; active &= active - 1) {
      const int lane = __builtin_ctz(active);
      Quad4<R> q = load_quad(quads[lane]);
      add_quad(q * (R(1) - first.at[lane]), force[pairs.node[0].at[lane]]);
      add_quad(q * first.at[lane], force[pairs.node[1].at[lane]]);
      q *= against;
      add_quad(q * (R(1) - second.at[lane]), force[pairs.node[2].at[lane]]);
      add_quad(q * second.at[lane], force[pairs.node[3].at[lane]]);
    }
  }
}

template <class R>
void box(const Features<R>& features, bool planes, const Quad<R>* x) {
  for (int i = 0; i < features.count; ++i) {
    Cluster<R>& cluster = features.clusters[i];
    const Vec3x<R> a = xyz(gather(x, cluster.node[0])), b = xyz(gather(x, cluster.node[1])),
                   c = xyz(gather(x, cluster.node[2]));
    const Vec3x<R> low = {least(a.x, least(b.x, c.x)), least(a.y, least(b.y, c.y)),
                          least(a.z, least(b.z, c.z))};
    const Vec3x<R> high = {largest(a.x, largest(b.x, c.x)), largest(a.y, largest(b.y, c.y)),
                           largest(a.z, largest(b.z, c.z))};
    ClusterBoxes<R>& boxes = features.boxes[i / kLanes];
    const Vec<R> lows[3] = {low.x, low.y, low.z}, highs[3] = {high.x, high.y, high.z};
    for (int k = 0; k < 3; ++k) {
      store(lows[k], cluster.low[k]), store(highs[k], cluster.high[k]);
      boxes.low[k].at[i % kLanes] = least_of(lows[k]);
      boxes.high[k].at[i % kLanes] = largest_of(highs[k]);
    }
    if (!planes) continue;
    const Vec3x<R> normal = cross(b - a, c - a);
    const Vec3x<R> unit = inverse_sqrt(dot(normal, normal) + all(kTiny_mm2<R>)) * normal;
    store(unit.x, cluster.plane[0]), store(unit.y, cluster.plane[1]);
    store(unit.z, cluster.plane[2]), store(dot(unit, a), cluster.plane[3]);
  }
}

/// Which of sixteen boxes are nearer than `reach` to [low, high] in each direction.
template <class R>
COAPT_INLINE Mask<R> meet(const Lane<R>* lows, const Lane<R>* highs, const R* low, const R* high,
                          const Vec<R>& reach) {
  Mask<R> mask = (load(lows[0]) - reach <= all(high[0])) & (all(low[0]) <= load(highs[0]) + reach);
  for (int k = 1; k < 3; ++k)
    mask = mask & (load(lows[k]) - reach <= all(high[k])) & (all(low[k]) <= load(highs[k]) + reach);
  return mask;
}

COAPT_INLINE unsigned first_lanes(int count) {
  return count >= kLanes ? 0xFFFFu : (1u << count) - 1u;
}

/// The clusters of `in.second` near cluster `c`, with their boxes; their number.
template <class R>
COAPT_INLINE int near_clusters(const PairSearch<R>& in, int c, const Vec<R>& reach) {
  const ClusterBoxes<R>& own = in.first.boxes[c / kLanes];
  R low[3], high[3];
  for (int k = 0; k < 3; ++k)
    low[k] = own.low[k].at[c % kLanes], high[k] = own.high[k].at[c % kLanes];
  int count = 0;
  for (int g = in.faces ? 0 : c / kLanes; g * kLanes < in.second.count; ++g) {
    const ClusterBoxes<R>& boxes = in.second.boxes[g];
    unsigned hits = bits(meet(boxes.low, boxes.high, low, high, reach)) &
                    first_lanes(in.second.count - g * kLanes);
    for (; hits != 0; hits &= hits - 1) {
      const int lane = __builtin_ctz(hits), other = g * kLanes + lane;
      if (!in.faces && other < c) continue;
      ClusterBoxes<R>& near = in.near_boxes[count / kLanes];
      for (int k = 0; k < 3; ++k) {
        near.low[k].at[count % kLanes] = boxes.low[k].at[lane];
        near.high[k].at[count % kLanes] = boxes.high[k].at[lane];
      }
      in.near_clusters[count++] = other;
    }
  }
  return count;
}

/// All pairs whose boxes (and, for faces, planes) are near enough, in order of their numbers.
template <class R>
COAPT_INLINE int find_pairs(const PairSearch<R>& in) {
  const Vec<R> reach = all(in.thickness_mm + in.margin_mm), zero = all(R(0));
  IndexLane lane_number;
  for (int i = 0; i < kLanes; ++i) lane_number.at[i] = i;
  int found = 0;
  for (int c = 0; c < in.first.count; ++c) {
    const int near_count = near_clusters(in, c, reach);
    const Cluster<R>& one = in.first.clusters[c];
    for (int i = 0; i < one.count; ++i) {
      const int number = kLanes * c + i;
      R low[3], high[3];
      for (int k = 0; k < 3; ++k) low[k] = one.low[k].at[i], high[k] = one.high[k].at[i];
      int near = in.near_begin[number];
      const int near_end = in.near_begin[number + 1];
      for (int g = 0; g * kLanes < near_count; ++g) {
        const ClusterBoxes<R>& boxes = in.near_boxes[g];
        unsigned met = bits(meet(boxes.low, boxes.high, low, high, reach)) &
                       first_lanes(near_count - g * kLanes);
        for (; met != 0; met &= met - 1) {
          const int other_number = in.near_clusters[g * kLanes + __builtin_ctz(met)];
          const Cluster<R>& other = in.second.clusters[other_number];
          while (near < near_end && in.near[near].cluster < other_number) ++near;
          const bool special = near < near_end && in.near[near].cluster == other_number;
          const Vec<R> thickness =
              special ? load(in.near[near].thickness_mm) : all(in.thickness_mm);
          const Vec<R> own_reach = thickness + all(in.margin_mm);
          Mask<R> mask = meet(other.low, other.high, low, high, own_reach) & (zero < thickness);
          if (in.faces) {
            const Vec<R> height = load(other.plane[0]) * all(low[0]) +
                                  load(other.plane[1]) * all(low[1]) +
                                  load(other.plane[2]) * all(low[2]) - load(other.plane[3]);
            mask = mask & (magnitude(height) <= own_reach);
          }
          unsigned hits = bits(mask) & first_lanes(other.count);
          if (!in.faces && other_number == c) hits &= ~((2u << i) - 1u);
          if (hits == 0) continue;
          if (found + kLanes <= in.capacity) {
            IndexLane first, second;
            Lane<R> thicknesses;
            for (int k = 0; k < kLanes; ++k) {
              first.at[k] = number;
              second.at[k] = kLanes * other_number + lane_number.at[k];
            }
            store(thickness, thicknesses);
            compress(first, hits, in.found.first + found);
            compress(second, hits, in.found.second + found);
            compress(thicknesses, hits, in.found.thickness_mm + found);
          }
          found += __builtin_popcount(hits);
        }
      }
    }
  }
  return found + kLanes <= in.capacity ? found : found + kLanes;
}

/// The four nodes of sixteen pairs; beyond `count` the last pair is repeated.
template <class R>
COAPT_INLINE void pair_nodes(const PairSearch<R>& in, const PairList<R>& list, int begin, int count,
                             IndexLane* node) {
  for (int lane = 0; lane < kLanes; ++lane) {
    const int pair = begin + (lane < count ? lane : count - 1);
    const int i = list.first[pair], j = list.second[pair];
    const Cluster<R>&one = in.first.clusters[i / kLanes], &other = in.second.clusters[j / kLanes];
    node[0].at[lane] = one.node[0].at[i % kLanes];
    node[1].at[lane] = in.faces ? other.node[0].at[j % kLanes] : one.node[1].at[i % kLanes];
    node[2].at[lane] = in.faces ? other.node[1].at[j % kLanes] : other.node[0].at[j % kLanes];
    node[3].at[lane] = in.faces ? other.node[2].at[j % kLanes] : other.node[1].at[j % kLanes];
  }
}

/// Lists pairs that may touch soon, those that are nearest to it first: so that whole blocks touch
/// or sleep.
template <class R>
PairCount list_pairs(const PairSearch<R>& in) {
  PairCount result;
  result.found = find_pairs(in);
  if (result.found > in.capacity) return result;
  // Room before touching at which a bin ends, as a share of the margin.
  const R ends[kBins] = {R(0.1) * in.margin_mm, R(0.3) * in.margin_mm, R(0.6) * in.margin_mm,
                         in.margin_mm};
  int size[kBins] = {};
  for (int begin = 0; begin < result.found; begin += kLanes) {
    const int count = result.found - begin < kLanes ? result.found - begin : kLanes;
    IndexLane node[4], first, second;
    Lane<R> thickness;
    pair_nodes(in, in.found, begin, count, node);
    for (int lane = 0; lane < kLanes; ++lane) {
      first.at[lane] = in.found.first[begin + lane];
      second.at[lane] = in.found.second[begin + lane];
      thickness.at[lane] = in.found.thickness_mm[begin + lane];
    }
    const Vec3x<R> d = in.faces ? face_apart(node, in.x).d : edges_apart(node, in.x).d;
    const Vec<R> distance2 = largest(dot(d, d), all(kTiny_mm2<R>));
    const Vec<R> room = distance2 * inverse_sqrt(distance2) - load(thickness);
    unsigned left = first_lanes(count);
    for (int b = 0; b < kBins; ++b) {
      const unsigned chosen = bits(room <= all(ends[b])) & left;
      left &= ~chosen;
      compress(first, chosen, in.bins[b].first + size[b]);
      compress(second, chosen, in.bins[b].second + size[b]);
      compress(thickness, chosen, in.bins[b].thickness_mm + size[b]);
      size[b] += __builtin_popcount(chosen);
    }
  }
  for (int b = 0; b < kBins; ++b) {
    for (int begin = 0; begin < size[b]; begin += kLanes) {
      const int count = size[b] - begin < kLanes ? size[b] - begin : kLanes;
      PairBlock<R>& block = in.blocks[result.blocks++];
      pair_nodes(in, in.bins[b], begin, count, block.node);
      block.asleep_until_mm = b == 0 ? R(0) : ends[b - 1];
      for (int lane = 0; lane < kLanes; ++lane) {
        block.thickness_mm.at[lane] = R(-1e6);  // padding: never near
        block.force_n_per_mm2.at[lane] = R(0);
        if (lane >= count) continue;
        const R thickness = in.bins[b].thickness_mm[begin + lane];
        R area = in.first.area_mm2[in.bins[b].first[begin + lane]];
        if (!in.faces) area += in.second.area_mm2[in.bins[b].second[begin + lane]];
        block.thickness_mm.at[lane] = thickness;
        block.force_n_per_mm2.at[lane] =
            in.stiffness_n_per_mm4 * area * in.thickness_mm / thickness;
      }
    }
  }
  return result;
}

#include "core/closure/kernels/sheets.inl"

template <class R>
constexpr Kernels<R> kTable = {advance<R>,    pull_cables<R>, pull_sheets<R>, push_faces<R>,
                               push_edges<R>, box<R>,         list_pairs<R>};
