// Part of kernels.inl: finding the pairs that may touch soon.

template <class R>
void box(const Features<R>& features, bool planes, R thickness, const Quad<R>* listed) {
  for (int i = 0; i < features.count; ++i) {
    Cluster<R>& cluster = features.clusters[i];
    const Vec4x<R> qa = gather(listed, cluster.node[0]), qb = gather(listed, cluster.node[1]),
                   qc = gather(listed, cluster.node[2]);
    const Vec3x<R> a = xyz(qa), b = xyz(qb), c = xyz(qc);
    const Vec3x<R> low = {least(a.x, least(b.x, c.x)), least(a.y, least(b.y, c.y)),
                          least(a.z, least(b.z, c.z))};
    const Vec3x<R> high = {largest(a.x, largest(b.x, c.x)), largest(a.y, largest(b.y, c.y)),
                           largest(a.z, largest(b.z, c.z))};
    const Vec<R> margin = largest(qa.w, largest(qb.w, qc.w));
    ClusterBoxes<R>& boxes = features.boxes[i / kLanes];
    const Vec<R> lows[3] = {low.x, low.y, low.z}, highs[3] = {high.x, high.y, high.z};
    const Vec<R> reach = all(thickness) + margin;
    store(reach, cluster.reach_mm);
    for (int k = 0; k < 3; ++k) {
      store(lows[k], cluster.low[k]), store(highs[k], cluster.high[k]);
      store(lows[k] - reach, cluster.reach_low[k]), store(highs[k] + reach, cluster.reach_high[k]);
      boxes.low[k].at[i % kLanes] = least_of(lows[k]);
      boxes.high[k].at[i % kLanes] = largest_of(highs[k]);
    }
    store(margin, cluster.margin_mm);
    boxes.margin_mm.at[i % kLanes] = largest_of(margin);
    cluster.least_margin_mm = least_of(margin);
    if (!planes) continue;
    const Vec3x<R> corners[3] = {a, b, c};
    for (int k = 0; k < 3; ++k) {
      store(corners[k].x, cluster.corner[k][0]), store(corners[k].y, cluster.corner[k][1]);
      store(corners[k].z, cluster.corner[k][2]);
    }
    const Vec3x<R> normal = cross(b - a, c - a);
    const Vec3x<R> unit = inverse_sqrt(dot(normal, normal) + all(kTiny_mm2<R>)) * normal;
    store(unit.x, cluster.plane[0]), store(unit.y, cluster.plane[1]);
    store(unit.z, cluster.plane[2]), store(dot(unit, a), cluster.plane[3]);
  }
}

/// A box and the margin of what is in it.
template <class R>
struct Box {
  R low[3], high[3], margin_mm;
};
template <class R, class Boxes>  // Cluster or ClusterBoxes
COAPT_INLINE Box<R> box_of(const Boxes& boxes, int lane) {
  Box<R> result;
  for (int k = 0; k < 3; ++k)
    result.low[k] = boxes.low[k].at[lane], result.high[k] = boxes.high[k].at[lane];
  result.margin_mm = boxes.margin_mm.at[lane];
  return result;
}

/// Which of sixteen boxes are nearer than `reach` to a box in each direction.
template <class R, class Boxes>
COAPT_INLINE Mask<R> meet(const Boxes& boxes, const Box<R>& box, const Vec<R>& reach) {
  const auto along = [&](int k) {
    return (load(boxes.low[k]) - reach <= all(box.high[k])) &
           (all(box.low[k]) <= load(boxes.high[k]) + reach);
  };
  return along(0) & along(1) & along(2);
}
template <class R, class Boxes>
COAPT_INLINE Vec<R> margin_of(const Boxes& boxes, const Box<R>& box) {
  return largest(load(boxes.margin_mm), all(box.margin_mm));
}

COAPT_INLINE unsigned first_lanes(int count) {
  return count >= kLanes ? 0xFFFFu : (1u << count) - 1u;
}

/// The clusters of `in.second`, from `from` on, near cluster `c` of the first; their number.
template <class R>
COAPT_INLINE int near_clusters(const PairSearch<R>& in, int c, int from) {
  const Box<R> own = box_of<R>(in.first.boxes[c / kLanes], c % kLanes);
  int count = 0;
  for (int g = from / kLanes; g * kLanes < in.second.count; ++g) {
    const ClusterBoxes<R>& boxes = in.second.boxes[g];
    unsigned hits = bits(meet(boxes, own, all(in.thickness_mm) + margin_of(boxes, own))) &
                    first_lanes(in.second.count - g * kLanes);
    for (; hits != 0; hits &= hits - 1) {
      const int other = g * kLanes + __builtin_ctz(hits);
      if (other >= from) in.near_clusters[count++] = other;
    }
  }
  return count;
}

/// Calls take(feature, other cluster, lanes, thickness) for all pairs whose boxes (and, for faces,
/// planes) are near enough, in order of the clusters; some further apart are among them. Thickness:
/// null where it is the law's.
template <class R, class Take>
COAPT_INLINE void find_pairs(const PairSearch<R>& in, Take take) {
  const Vec<R> zero = all(R(0)), full = all(in.thickness_mm);
  for (int c = 0; c < in.first.count; ++c) {
    const Cluster<R>& one = in.first.clusters[c];
    const NearAtRest<R>*near = in.near + in.near_begin[c],
          *near_end = in.near + in.near_begin[c + 1];
    const int near_count = near_clusters(in, c, in.faces ? 0 : c);
    for (int n = 0; n < near_count; ++n) {
      const int o = in.near_clusters[n];
      const Cluster<R>& other = in.second.clusters[o];
      const Box<R> around = box_of<R>(in.second.boxes[o / kLanes], o % kLanes);
      while (near != near_end && near->cluster < o) ++near;
      unsigned met =
          bits(meet(one, around, full + margin_of(one, around))) & first_lanes(one.count);
      for (; met != 0; met &= met - 1) {
        const int i = __builtin_ctz(met);
        // The margin of a pair is the larger one: so much more than that of the others, at most.
        const R further = one.margin_mm.at[i] - other.least_margin_mm;
        const Vec<R> more = all(further > R(0) ? further : R(0));
        const auto along = [&](int k) {
          return (load(other.reach_low[k]) <= all(one.high[k].at[i]) + more) &
                 (all(one.low[k].at[i]) - more <= load(other.reach_high[k]));
        };
        unsigned hits = bits(along(0) & along(1) & along(2)) & first_lanes(other.count);
        if (!in.faces && o == c) hits &= ~((2u << i) - 1u);
        if (hits == 0) continue;
        if (in.faces) {
          const Vec<R> height = load(other.plane[0]) * all(one.low[0].at[i]) +
                                load(other.plane[1]) * all(one.low[1].at[i]) +
                                load(other.plane[2]) * all(one.low[2].at[i]) - load(other.plane[3]);
          hits &= bits(magnitude(height) <= load(other.reach_mm) + more);
        }
        while (near != near_end && near->cluster == o && near->lane < i) ++near;
        const bool special = near != near_end && near->cluster == o && near->lane == i;
        if (special) hits &= bits(zero < load(near->thickness_mm));
        if (hits != 0) take(kLanes * c + i, o, hits, special ? &near->thickness_mm : nullptr);
      }
    }
  }
}

template <class R>
COAPT_INLINE void nodes_of_pair(const PairSearch<R>& in, int first, int second, int lane,
                                IndexLane* node) {
  const Feature<R>&a = in.first.each[first], &b = in.second.each[second];
  const int of_first = in.faces ? 1 : 2;
  for (int k = 0; k < of_first; ++k) node[k].at[lane] = a.node[k];
  for (int k = of_first; k < 4; ++k) node[k].at[lane] = b.node[k - of_first];
}

/// Puts what find_pairs() finds into the buffer, padded to whole blocks by pairs that are never
/// near; the number of pairs. More than the buffer's room: that it needs.
template <class R>
COAPT_INLINE int buffer_pairs(const PairSearch<R>& in) {
  const PairBuffer<R>& buffer = in.buffer;
  const Vec<R> full = all(in.thickness_mm);
  int count = 0;
  find_pairs(in, [&](int feature, int o, unsigned hits, const Lane<R>* thickness) {
    const int here = count;
    count += __builtin_popcount(hits);
    if (here + kLanes > buffer.room) return;
    for (int k = 0; k < kLanes; ++k) buffer.first[here + k] = feature;
    compress_numbers(kLanes * o, hits, buffer.second + here);
    if (thickness)
      compress(load(*thickness), hits, buffer.thickness_mm + here);
    else
      store(full, buffer.thickness_mm + here);
  });
  if (count + kLanes > buffer.room) return count + kLanes;
  for (int k = count; k < kLanes * blocks_for(static_cast<unsigned long>(count)); ++k) {
    buffer.first[k] = buffer.first[0], buffer.second[k] = buffer.second[0];
    buffer.thickness_mm[k] = R(-1e6);
  }
  return count;
}

/// Where a bin ends: room before touching as a share of the margin.
template <class R>
constexpr R kBinEnds[kPairBins] = {R(0.1), R(0.3), R(0.6), R(1)};

/// Fills the buffer's bins and margins; how many pairs each bin has. Those with more room than their
/// margin are in none.
template <class R>
COAPT_INLINE void bin_pairs(const PairSearch<R>& in, int count, int (&binned)[kPairBins]) {
  const PairBuffer<R>& buffer = in.buffer;
  for (int start = 0; start < count; start += kLanes) {
    IndexLane node[4];
    for (int i = 0; i < kLanes; ++i)
      nodes_of_pair(in, buffer.first[start + i], buffer.second[start + i], i, node);
    Vec<R> margin;
    const Vec3x<R> d =
        in.faces ? face_apart(node, in.listed, &margin).d : edges_apart(node, in.listed, &margin).d;
    const Vec<R> distance2 = largest(dot(d, d), all(kTiny_mm2<R>));
    const Vec<R> space = distance2 * inverse_sqrt(distance2) - load<R>(buffer.thickness_mm + start);
    store(margin, buffer.margin_mm + start);
    unsigned left = first_lanes(count - start);
    for (int b = 0; b < kPairBins; ++b) {
      const unsigned chosen = bits(space <= all(kBinEnds<R>[b]) * margin) & left;
      left &= ~chosen;
      compress_numbers(start, chosen, buffer.binned[b] + binned[b]);
      binned[b] += __builtin_popcount(chosen);
    }
  }
}

/// Up to sixteen pairs of a bin; padding is never near.
template <class R>
COAPT_INLINE void pack(const PairSearch<R>& in, const int* pairs, int count, PairBlock<R>& block) {
  Lane<R> thickness, area, margin;
  for (int i = 0; i < kLanes; ++i) {
    const bool real = i < count;
    const int pair = pairs[real ? i : 0];
    const int first = in.buffer.first[pair], second = in.buffer.second[pair];
    nodes_of_pair(in, first, second, i, block.node);
    thickness.at[i] = real ? in.buffer.thickness_mm[pair] : R(-1e6);
    area.at[i] = real ? in.first.each[first].area_mm2 + in.second.each[second].area_mm2 : R(0);
    margin.at[i] = real ? in.buffer.margin_mm[pair] : R(1);
  }
  store(load(thickness), block.thickness_mm);
  store(all(in.stiffness_n_per_mm4 * in.thickness_mm) * load(area) / load(thickness),
        block.force_n_per_mm2);
  store(all(R(1)) / load(margin), block.per_margin_mm);
}

template <class R>
int list_pairs(const PairSearch<R>& in, PairBlock<R>* blocks, int room) {
  const int count = buffer_pairs(in);
  if (count > in.buffer.room || in.buffer.room == 0) return -1 - count;
  int binned[kPairBins] = {}, used = 0;
  bin_pairs(in, count, binned);
  for (int b = 0; b < kPairBins; ++b) {
    for (int start = 0; start < binned[b]; start += kLanes) {
      if (used++ >= room) continue;
      PairBlock<R>& block = blocks[used - 1];
      pack(in, in.buffer.binned[b] + start, binned[b] - start, block);
      block.asleep_until = b == 0 ? R(0) : kBinEnds<R>[b - 1];
    }
  }
  return used;
}

constexpr int kMostPairs = 1 << 30;  // counted; a valid valve has far fewer

template <class R>
int number_pairs(const PairSearch<R>& in, int* first, int* second, int room) {
  int count = 0;
  find_pairs(in, [&](int feature, int o, unsigned hits, const Lane<R>*) {
    for (; hits != 0; hits &= hits - 1) {
      if (count >= room) {
        if (count < kMostPairs) ++count;
        continue;
      }
      first[count] = feature;
      second[count++] = kLanes * o + __builtin_ctz(hits);
    }
  });
  return count;
}
