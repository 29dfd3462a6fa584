// Part of kernels.inl: which faces may pass through each other.

/// Heights of some nodes over a plane, those left out that are in it anyway.
template <class R>
struct Heights {
  Vec<R> low = all(R(1e6)), high = all(R(-1e6));

  COAPT_INLINE void add(const Vec<R>& height, const Mask<R>& in_plane) {
    low = least(low, select(in_plane, all(R(1e6)), height));
    high = largest(high, select(in_plane, all(R(-1e6)), height));
  }
  /// Whether they are on both sides; one node alone has no edge without one that is left out.
  COAPT_INLINE Mask<R> on_both_sides(const Vec<R>& near) const {
    return (low < near) & (all(R(0)) - near < high) & (low < high);
  }
};

template <class R>
int straddling_faces(const PairSearch<R>& in, int* first, int* second, int room) {
  const Vec<R> near = all(in.thickness_mm);
  int count = 0;
  for (int c = 0; c < in.second.count; ++c) {
    const int near_count = near_clusters(in, c, c);
    const Cluster<R>& one = in.second.clusters[c];
    for (int n = 0; n < near_count; ++n) {
      const int o = in.near_clusters[n];
      const Cluster<R>& other = in.second.clusters[o];
      unsigned met = bits(meet(one, box_of<R>(in.second.boxes[o / kLanes], o % kLanes), near)) &
                     first_lanes(one.count);
      for (; met != 0; met &= met - 1) {
        const int i = __builtin_ctz(met);
        unsigned hits = bits(meet(other, box_of<R>(one, i), near)) & first_lanes(other.count);
        if (o == c) hits &= ~((2u << i) - 1u);
        if (hits == 0) continue;
        Mask<R> same[3][3];  // [node of this face][node of the others]
        for (int k = 0; k < 3; ++k)
          for (int m = 0; m < 3; ++m) same[k][m] = lanes_with<R>(other.node[m], one.node[k].at[i]);
        Heights<R> over_others, over_this;
        for (int k = 0; k < 3; ++k) {
          over_others.add(load(other.plane[0]) * all(one.corner[k][0].at[i]) +
                              load(other.plane[1]) * all(one.corner[k][1].at[i]) +
                              load(other.plane[2]) * all(one.corner[k][2].at[i]) -
                              load(other.plane[3]),
                          same[k][0] | same[k][1] | same[k][2]);
          over_this.add(all(one.plane[0].at[i]) * load(other.corner[k][0]) +
                            all(one.plane[1].at[i]) * load(other.corner[k][1]) +
                            all(one.plane[2].at[i]) * load(other.corner[k][2]) -
                            all(one.plane[3].at[i]),
                        same[0][k] | same[1][k] | same[2][k]);
        }
        hits &= bits(over_others.on_both_sides(near) & over_this.on_both_sides(near));
        for (; hits != 0; hits &= hits - 1, ++count) {
          if (count >= room) continue;
          first[count] = kLanes * c + i;
          second[count] = kLanes * o + __builtin_ctz(hits);
        }
      }
    }
  }
  return count;
}
