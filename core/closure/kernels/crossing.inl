// Part of kernels.inl: which faces may pass through each other.

template <class R>
int straddling_faces(const PairSearch<R>& in, int* first, int* second, int room) {
  const Vec<R> zero = all(R(0)), near = all(in.thickness_mm), far = all(R(1e6));
  int count = 0;
  for (int c = 0; c < in.second.count; ++c) {
    const int near_count = near_clusters(in, c, 0);
    const Cluster<R>& one = in.second.clusters[c];
    for (int n = 0; n < near_count; ++n) {
      const int o = in.near_clusters[n];
      const Cluster<R>& other = in.second.clusters[o];
      unsigned met = bits(meet(one, box_of<R>(in.second.boxes[o / kLanes], o % kLanes), near)) &
                     first_lanes(one.count);
      for (; met != 0; met &= met - 1) {
        const int i = __builtin_ctz(met);
        unsigned hits = bits(meet(other, box_of<R>(one, i), near)) & first_lanes(other.count);
        if (o == c) hits &= ~(1u << i);
        if (hits == 0) continue;
        Vec<R> low = far, high = zero - far;
        for (int k = 0; k < 3; ++k) {
          const int node = one.node[k].at[i];
          const Quad<R>& x = in.listed[node];
          const Vec<R> height = load(other.plane[0]) * all(x.at[0]) +
                                load(other.plane[1]) * all(x.at[1]) +
                                load(other.plane[2]) * all(x.at[2]) - load(other.plane[3]);
          Mask<R> shared = lanes_with<R>(other.node[0], node);
          for (int m = 1; m < 3; ++m) shared = shared | lanes_with<R>(other.node[m], node);
          low = least(low, select(shared, far, height));
          high = largest(high, select(shared, zero - far, height));
        }
        // One node left: the others are shared, and no edge is without one.
        hits &= bits((low < near) & (zero - near < high) & (low < high));
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
