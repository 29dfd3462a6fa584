// Part of kernels.inl: which faces may pass through each other.

template <class R>
COAPT_INLINE Mask<R> equal(const IndexLane& lanes, int value) {
  Lane<R> same;
  for (int i = 0; i < kLanes; ++i) same.at[i] = lanes.at[i] == value ? R(1) : R(0);
  return all(R(0)) < load(same);
}

template <class R>
int straddling_faces(const PairSearch<R>& in, int* first, int* second, int room) {
  const Vec<R> zero = all(R(0)), near = all(in.thickness_mm), far = all(R(1e6));
  int count = 0;
  for (int c = 0; c < in.second.count; ++c) {
    const int near_count = near_clusters(in, c, 0);
    const Cluster<R>& one = in.second.clusters[c];
    for (int i = 0; i < one.count; ++i) {
      const Box<R> own = box_of<R>(one, i);
      for (int g = 0; g * kLanes < near_count; ++g) {
        unsigned met = bits(meet(in.near_boxes[g], own, near)) & first_lanes(near_count - g * kLanes);
        for (; met != 0; met &= met - 1) {
          const int other_number = in.near_clusters[g * kLanes + __builtin_ctz(met)];
          const Cluster<R>& other = in.second.clusters[other_number];
          unsigned hits = bits(meet(other, own, near)) & first_lanes(other.count);
          if (other_number == c) hits &= ~(1u << i);
          if (hits == 0) continue;
          Vec<R> low = far, high = zero - far;
          for (int k = 0; k < 3; ++k) {
            const int node = one.node[k].at[i];
            const Quad<R>& x = in.listed[node];
            const Vec<R> height = load(other.plane[0]) * all(x.at[0]) +
                                  load(other.plane[1]) * all(x.at[1]) +
                                  load(other.plane[2]) * all(x.at[2]) - load(other.plane[3]);
            Mask<R> shared = equal<R>(other.node[0], node);
            for (int n = 1; n < 3; ++n) shared = shared | equal<R>(other.node[n], node);
            low = least(low, select(shared, far, height));
            high = largest(high, select(shared, zero - far, height));
          }
          // One node left: the others are shared, and no edge is without one.
          hits &= bits((low < near) & (zero - near < high) & (low < high));
          for (; hits != 0; hits &= hits - 1, ++count) {
            if (count >= room) continue;
            first[count] = kLanes * c + i;
            second[count] = kLanes * other_number + __builtin_ctz(hits);
          }
        }
      }
    }
  }
  return count;
}
