// Part of kernels.inl: finding the pairs that may touch soon.

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
