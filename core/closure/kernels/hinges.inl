// Hinges between faces, sixteen at a time: core/closure/hinges.cpp, written for lanes. Included by
// kernels.inl, after sheets.inl.

template <class R>
void turn_hinges(const HingeInput<R>& in) {
  const Vec<R> zero = all(R(0)), half = all(R(0.5)), one = all(R(1)), four = all(R(4));
  const Vec<R> least_cosine = all(R(1e-3)), tiny = all(kTiny_mm2<R>);
  for (int b = 0; b < in.block_count; ++b) {
    const HingeBlock<R>& hinge = in.blocks[b];
    const Vec3x<R> x0 = xyz(gather(in.x, hinge.node[0]));
    const Vec3x<R> e = xyz(gather(in.x, hinge.node[1])) - x0,
                   to2 = xyz(gather(in.x, hinge.node[2])) - x0,
                   to3 = xyz(gather(in.x, hinge.node[3])) - x0;
    const Vec3x<R> n1 = cross(e, to2), n2 = cross(to3, e);
    const Vec<R> e2 = dot(e, e) + tiny, per_length = inverse_sqrt(e2);
    const Vec<R> least_mm4 = load(hinge.least_mm4);
    const Vec<R> per_area1 = inverse_sqrt(largest(dot(n1, n1), least_mm4)),
                 per_area2 = inverse_sqrt(largest(dot(n2, n2), least_mm4));
    const Vec<R> per_areas = per_area1 * per_area2;
    const Vec<R> cosine = largest(zero - one, least(one, dot(n1, n2) * per_areas));
    const Vec<R> sine = dot(cross(n1, n2), e) * per_areas * per_length;
    const Vec<R> half_cosine2 = largest(half * (one + cosine), tiny);
    const Vec<R> half_cosine = half_cosine2 * inverse_sqrt(half_cosine2);
    const Vec<R> half_sine = half * sine / largest(half_cosine, least_cosine);
    const Vec<R> turned = four * half_sine / (one + half_cosine) - load(hinge.rest);
    const Vec<R> stiffness = load(hinge.stiffness_n_mm);
    const Vec<R> moment = stiffness * turned, length = e2 * per_length;
    // Gradients of the angle at nodes 2 and 3, and their shares of the two on the edge.
    const Vec3x<R> g2 = (zero - length * per_area1 * per_area1) * n1,
                   g3 = (zero - length * per_area2 * per_area2) * n2;
    const Vec<R> per_e2 = per_length * per_length;
    const Vec<R> s2 = dot(to2, e) * per_e2, s3 = dot(to3, e) * per_e2;
    const Vec3x<R> gradient[4] = {(s2 - one) * g2 + (s3 - one) * g3, (zero - s2) * g2 - s3 * g3, g2,
                                  g3};
    Vec<R> size[4], sum = zero;
    for (int k = 0; k < 4; ++k) {
      const Vec<R> size2 = dot(gradient[k], gradient[k]) + tiny;
      size[k] = size2 * inverse_sqrt(size2);
      sum = sum + size[k];
    }
    // Half a row sum, as for sheets.
    const Vec<R> row = half * stiffness * (one + magnitude(turned)) * sum;
    const unsigned active = bits(zero < stiffness);
    for (int k = 0; k < 4; ++k) {
      const Vec3x<R> f = moment * gradient[k];
      add_to_nodes(hinge.node[k], active,
                   Vec4x<R>{zero - f.x, zero - f.y, zero - f.z, row * size[k]}, in.force);
    }
  }
}
