// Sixteen faces at a time: what membrane, bending and pressure do to their corners. Included by
// kernels.inl, after sheets.inl and exponential.inl.

/// A force on a corner and its stiffness.
template <class R>
COAPT_INLINE void add(Vec4x<R>& corner, const Vec3x<R>& force, const Vec<R>& stiffness) {
  corner.x = corner.x + force.x, corner.y = corner.y + force.y, corner.z = corner.z + force.z;
  corner.w = corner.w + stiffness;
}

template <class R, FaceLaw kLaw>
COAPT_INLINE void add_membrane(const FaceInput<R>& in, int b, const Vec3x<R>& ab,
                               const Vec3x<R>& ac, Vec4x<R> (&corner)[3]) {
  if constexpr (kLaw != FaceLaw::None) {
    const Vec<R> zero = all(R(0));
    const FaceBlock<R>& block = in.blocks[b];
    Images<R> image;
    image.b1 = load(block.along[0]), image.c1 = load(block.along[1]);
    image.b2 = load(block.across[0]), image.c2 = load(block.across[1]);
    image.a1 = zero - image.b1 - image.c1, image.a2 = zero - image.b2 - image.c2;
    image.f1 = image.b1 * ab + image.c1 * ac, image.f2 = image.b2 * ab + image.c2 * ac;
    Stretched<R> now;
    if constexpr (kLaw == FaceLaw::Continuum)
      now = stretch_continuum(in, block, image);
    else
      now = stretch_exponential(in, b, image);
    const Vec<R>&h1 = now.h1, &h2 = now.h2;
    const Vec<R> with_ab = magnitude(h1 * image.a1 * image.b1 + h2 * image.a2 * image.b2),
                 with_bc = magnitude(h1 * image.b1 * image.c1 + h2 * image.b2 * image.c2),
                 with_ca = magnitude(h1 * image.c1 * image.a1 + h2 * image.c2 * image.a2);
    const auto pull = [&](int k, const Vec<R>& g1, const Vec<R>& g2, const Vec<R>& others) {
      const Vec3x<R> f = g1 * now.p1 + g2 * now.p2;
      add(corner[k], Vec3x<R>{zero - f.x, zero - f.y, zero - f.z},
          h1 * g1 * g1 + h2 * g2 * g2 + others);
    };
    pull(0, image.a1, image.a2, with_ab + with_ca);
    pull(1, image.b1, image.b2, with_ab + with_bc);
    pull(2, image.c1, image.c2, with_bc + with_ca);
  }
}

/// Pressure, and the moments of the hinges at the three edges: all of it along the normal. A moment M
/// at an edge of length l pushes the corner across by M l / |n|^2 times the normal n, and the edge's
/// own two by that divided at the foot of the face's height (hinges.cpp has the gradients).
template <class R>
COAPT_INLINE void add_along_normal(const FaceInput<R>& in, const FaceBlock<R>& block,
                                   const Vec3x<R>& ab, const Vec3x<R>& ac, Vec4x<R> (&corner)[3]) {
  const Vec3x<R> normal = cross(ab, ac);
  const Vec<R> tiny = all(kTiny_mm2<R>), half = all(R(0.5));
  const Vec<R> ab2 = dot(ab, ab), ac2 = dot(ac, ac), mixed = dot(ab, ac);
  const Vec<R> bc2 = ab2 + ac2 - (mixed + mixed);
  const Vec<R> per_area = inverse_sqrt(largest(dot(normal, normal), load(block.least_mm4)));
  const Vec<R> per_area2 = per_area * per_area;
  // From the first corner of each edge to the foot, times the edge's length.
  const Vec<R> foot[3] = {mixed, ab2 - mixed, ac2 - mixed}, edge2[3] = {ab2, bc2, ac2};
  const Vec<R> load_mpa = load(block.load_mpa);
  Vec<R> push[3] = {load_mpa, load_mpa, load_mpa}, length[3], stiffness[3];
  for (Vec<R>& s : stiffness) s = all(R(0));
  for (int k = 0; k < 3; ++k) {
    const int first = k, second = (k + 1) % 3, across = (k + 2) % 3;
    const Vec<R> e2 = largest(edge2[k], tiny), per_length = inverse_sqrt(e2);
    length[k] = e2 * per_length;
    const Vec<R> moment = gather(in.hinges->moment_n_mm.at, block.hinge[k]),
                 turned = gather(in.hinges->stiffness_n.at, block.hinge[k]);
    const Vec<R> per_edge = moment * per_area2 * per_length, stiff = turned * per_area * per_length;
    const Vec<R> rest = e2 - foot[k];
    const Vec<R> turning = half * magnitude(moment);
    const Vec<R> on_edge =
        turning * (all(R(3)) * per_area + (per_length + per_length) * per_length);
    push[across] = push[across] + per_edge * e2;
    push[second] = push[second] - per_edge * foot[k];
    push[first] = push[first] - per_edge * rest;
    stiffness[across] = stiffness[across] + stiff * e2 + (turning + turning) * per_area;
    stiffness[second] = stiffness[second] + stiff * magnitude(foot[k]) + on_edge;
    stiffness[first] = stiffness[first] + stiff * magnitude(rest) + on_edge;
  }
  for (int k = 0; k < 3; ++k)
    add(corner[k], push[k] * normal, stiffness[k] + load_mpa * (length[k] + length[(k + 2) % 3]));
}

template <class R, FaceLaw kLaw>
COAPT_INLINE void pull_faces_of(const FaceInput<R>& in) {
  const Vec<R> zero = all(R(0));
  for (int b = 0; b < in.block_count; ++b) {
    const FaceBlock<R>& block = in.blocks[b];
    const Vec3x<R> a = xyz(gather(in.x, block.node[0]));
    const Vec3x<R> ab = xyz(gather(in.x, block.node[1])) - a,
                   ac = xyz(gather(in.x, block.node[2])) - a;
    Vec4x<R> corner[3];
    for (Vec4x<R>& c : corner) c = {zero, zero, zero, zero};
    add_membrane<R, kLaw>(in, b, ab, ac, corner);
    add_along_normal(in, block, ab, ac, corner);
    for (int k = 0; k < 3; ++k) store_quads(corner[k], in.corners + kLanes * (3 * b + k));
  }
}

template <class R>
void pull_faces(const FaceInput<R>& in) {
  switch (in.law) {
    case FaceLaw::None:
      return pull_faces_of<R, FaceLaw::None>(in);
    case FaceLaw::Continuum:
      return pull_faces_of<R, FaceLaw::Continuum>(in);
    case FaceLaw::Exponential:
      return pull_faces_of<R, FaceLaw::Exponential>(in);
  }
}
