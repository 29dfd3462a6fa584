// Part of kernels.inl: finding the pairs that may touch soon.

template <class R>
void box(const Features<R>& features, bool planes, const Quad<R>* listed) {
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
    for (int k = 0; k < 3; ++k) {
      store(lows[k], cluster.low[k]), store(highs[k], cluster.high[k]);
      boxes.low[k].at[i % kLanes] = least_of(lows[k]);
      boxes.high[k].at[i % kLanes] = largest_of(highs[k]);
    }
    store(margin, cluster.margin_mm);
    boxes.margin_mm.at[i % kLanes] = largest_of(margin);
    if (!planes) continue;
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

/// Calls take(cluster, lane, other cluster, lanes, thickness, margin) for all pairs whose boxes
/// (and, for faces, planes) are near enough, in order of the clusters.
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
        const Box<R> own = box_of<R>(one, i);
        while (near != near_end && near->cluster == o && near->lane < i) ++near;
        const bool special = near != near_end && near->cluster == o && near->lane == i;
        const Vec<R> thickness = special ? load(near->thickness_mm) : full;
        const Vec<R> margin = margin_of(other, own), reach = thickness + margin;
        Mask<R> mask = meet(other, own, reach) & (zero < thickness);
        if (in.faces) {
          const Vec<R> height = load(other.plane[0]) * all(own.low[0]) +
                                load(other.plane[1]) * all(own.low[1]) +
                                load(other.plane[2]) * all(own.low[2]) - load(other.plane[3]);
          mask = mask & (magnitude(height) <= reach);
        }
        unsigned hits = bits(mask) & first_lanes(other.count);
        if (!in.faces && o == c) hits &= ~((2u << i) - 1u);
        if (hits != 0) take(c, i, o, hits, thickness, margin);
      }
    }
  }
}

/// Pairs that wait until there are sixteen.
template <class R>
struct Waiting {
  int node[4][2 * kLanes];
  R thickness_mm[2 * kLanes], area_mm2[2 * kLanes], margin_mm[2 * kLanes];
  int count = 0;

  COAPT_INLINE void add_node(int k, const IndexLane& lanes, unsigned chosen) {
    compress(lanes, chosen, node[k] + count);
  }
  COAPT_INLINE void add_node(int k, int everywhere) {
    for (int i = 0; i < kLanes; ++i) node[k][count + i] = everywhere;
  }
  /// After its nodes.
  COAPT_INLINE void add(const Vec<R>& thickness, const Vec<R>& area, const Vec<R>& margin,
                        unsigned chosen) {
    compress(thickness, chosen, thickness_mm + count);
    compress(area, chosen, area_mm2 + count);
    compress(margin, chosen, margin_mm + count);
    count += __builtin_popcount(chosen);
  }
  /// Drops the first sixteen.
  COAPT_INLINE void drop() {
    for (int k = 0; k < 4; ++k) __builtin_memcpy(node[k], node[k] + kLanes, sizeof(int) * kLanes);
    __builtin_memcpy(thickness_mm, thickness_mm + kLanes, sizeof(R) * kLanes);
    __builtin_memcpy(area_mm2, area_mm2 + kLanes, sizeof(R) * kLanes);
    __builtin_memcpy(margin_mm, margin_mm + kLanes, sizeof(R) * kLanes);
    count -= kLanes;
  }
  /// The nodes of the first sixteen; where there are fewer, the first is repeated.
  COAPT_INLINE void first_nodes(IndexLane* nodes) {
    for (int k = 0; k < 4; ++k) {
      for (int i = count; i < kLanes; ++i) node[k][i] = node[k][0];
      __builtin_memcpy(nodes[k].at, node[k], sizeof nodes[k].at);
    }
  }
};
template <class R>
COAPT_INLINE Vec<R> load_first(const R* at) {
  Vec<R> result;
  __builtin_memcpy(&result, at, sizeof result);
  return result;
}

/// Packs pairs into blocks, those of like room to move together, so that whole blocks touch or
/// sleep.
template <class R>
struct Packer {
  static constexpr int kBins = 4;
  /// Where a bin ends: room before touching as a share of the margin.
  static constexpr R kEnds[kBins] = {R(0.1), R(0.3), R(0.6), R(1)};

  const PairSearch<R>& in;
  PairBlock<R>* blocks;
  int room, used = 0;
  Waiting<R> found, bins[kBins];

  COAPT_INLINE void sort_found() {
    IndexLane node[4];
    const int count = found.count < kLanes ? found.count : kLanes;
    found.first_nodes(node);
    const Vec3x<R> d = in.faces ? face_apart(node, in.listed).d : edges_apart(node, in.listed).d;
    const Vec<R> distance2 = largest(dot(d, d), all(kTiny_mm2<R>));
    const Vec<R> thickness = load_first(found.thickness_mm), margin = load_first(found.margin_mm);
    const Vec<R> space = distance2 * inverse_sqrt(distance2) - thickness;
    unsigned left = first_lanes(count);
    for (int b = 0; b < kBins && left != 0; ++b) {
      const unsigned chosen = bits(space <= all(kEnds[b]) * margin) & left;
      left &= ~chosen;
      if (chosen == 0) continue;
      for (int k = 0; k < 4; ++k) bins[b].add_node(k, node[k], chosen);
      bins[b].add(thickness, load_first(found.area_mm2), margin, chosen);
      if (bins[b].count >= kLanes) pack(b);
    }
    if (found.count > kLanes)
      found.drop();
    else
      found.count = 0;
  }
  COAPT_INLINE void pack(int b) {
    Waiting<R>& bin = bins[b];
    if (used++ < room) {
      PairBlock<R>& block = blocks[used - 1];
      bin.first_nodes(block.node);
      block.asleep_until = b == 0 ? R(0) : kEnds[b - 1];
      for (int i = bin.count; i < kLanes; ++i) {
        bin.thickness_mm[i] = R(-1e6);  // padding: never near
        bin.area_mm2[i] = R(0);
        bin.margin_mm[i] = R(1);
      }
      const Vec<R> thickness = load_first(bin.thickness_mm);
      store(thickness, block.thickness_mm);
      store(all(in.stiffness_n_per_mm4 * in.thickness_mm) * load_first(bin.area_mm2) / thickness,
            block.force_n_per_mm2);
      store(all(R(1)) / load_first(bin.margin_mm), block.per_margin_mm);
    }
    if (bin.count > kLanes)
      bin.drop();
    else
      bin.count = 0;
  }
};

template <class R>
int list_pairs(const PairSearch<R>& in, PairBlock<R>* blocks, int room) {
  Packer<R> packer{in, blocks, room, 0, {}, {}};
  find_pairs(
      in, [&](int c, int i, int o, unsigned hits, const Vec<R>& thickness, const Vec<R>& margin) {
        const Cluster<R>&one = in.first.clusters[c], &other = in.second.clusters[o];
        Waiting<R>& found = packer.found;
        found.add_node(0, one.node[0].at[i]);
        if (in.faces) {
          for (int k = 0; k < 3; ++k) found.add_node(k + 1, other.node[k], hits);
        } else {
          found.add_node(1, one.node[1].at[i]);
          for (int k = 0; k < 2; ++k) found.add_node(k + 2, other.node[k], hits);
        }
        found.add(thickness, all(one.area_mm2.at[i]) + load(other.area_mm2), margin, hits);
        if (found.count >= kLanes) packer.sort_found();
      });
  if (packer.found.count > 0) packer.sort_found();
  for (int b = 0; b < Packer<R>::kBins; ++b)
    if (packer.bins[b].count > 0) packer.pack(b);
  return packer.used;
}

constexpr int kMostPairs = 1 << 30;  // counted; a valid valve has far fewer

template <class R>
int number_pairs(const PairSearch<R>& in, int* first, int* second, int room) {
  int count = 0;
  find_pairs(in, [&](int c, int i, int o, unsigned hits, const Vec<R>&, const Vec<R>&) {
    for (; hits != 0; hits &= hits - 1) {
      if (count >= room) {
        if (count < kMostPairs) ++count;
        continue;
      }
      first[count] = kLanes * c + i;
      second[count++] = kLanes * o + __builtin_ctz(hits);
    }
  });
  return count;
}
