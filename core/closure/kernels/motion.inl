// Part of kernels.inl: cables, springs, and the step of all nodes.

/// Added to a squared length, or its least value, mm2: points in one place give no infinity.
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

/// Adds force `f` with `stiffness` to the first `plus` nodes of the active lanes, by their weights,
/// and what balances it to the others.
template <class R>
COAPT_INLINE void scatter(const IndexLane* node, unsigned active, const Vec3x<R>& f,
                          const Vec<R>& stiffness, const Vec<R> (&weight)[4], int plus,
                          Quad<R>* force) {
  Quad<R> quads[kLanes];
  Lane<R> share[4];
  store_quads(Vec4x<R>{f.x, f.y, f.z, stiffness}, quads);
  for (int k = 0; k < 4; ++k) store(weight[k], share[k]);
  const Quad4<R> against = {-1, -1, -1, 1};
  for (; active != 0; active &= active - 1) {
    const int lane = __builtin_ctz(active);
    Quad4<R> q = load_quad(quads[lane]);
    for (int k = 0; k < 4; ++k) {
      if (k == plus) q *= against;
      add_quad(q * share[k].at[lane], at_offset(force, node[k].at[lane]));
    }
  }
}

template <class R>
void pull_cables(const CableInput<R>& in) {
  for (int b = 0; b < in.block_count; ++b) {
    const CableBlock<R>& c = in.blocks[b];
    Quad<R> ends[kLanes];
    for (int lane = 0; lane < kLanes; ++lane) {
      Quad4<R> end = {};
      for (int s = c.first_share[lane]; s < c.first_share[lane + 1]; ++s)
        end += load_quad(at_offset(in.x, in.shares[s].node)) * in.shares[s].weight;
      __builtin_memcpy(&ends[lane].at, &end, sizeof end);
    }
    const Vec3x<R> d = xyz(load_quads(ends)) - xyz(gather(in.x, c.start));
    const Vec<R> stiffness = load(c.stiffness_n_per_mm);
    const Vec<R> length2 = dot(d, d) + all(kTiny_mm2<R>);
    const Vec<R> inverse = inverse_sqrt(length2);
    const Vec<R> stretch = largest(length2 * inverse - load(c.rest_mm), all(R(0)));
    // A slack cable weighs as much as a taut one: else its end rattles between the two.
    const Vec3x<R> f = (stiffness * stretch * inverse) * d;
    Quad<R> pulls[kLanes];
    store_quads(Vec4x<R>{f.x, f.y, f.z, stiffness}, pulls);
    const Quad4<R> against = {-1, -1, -1, 1};
    for (unsigned active = bits(all(R(0)) < stiffness); active != 0; active &= active - 1) {
      const int lane = __builtin_ctz(active);
      const Quad4<R> pull = load_quad(pulls[lane]), back = pull * against;
      add_quad(pull, at_offset(in.force, c.start.at[lane]));
      for (int s = c.first_share[lane]; s < c.first_share[lane + 1]; ++s)
        add_quad(back * in.shares[s].weight, at_offset(in.force, in.shares[s].node));
    }
  }
}

template <class R>
StepSums advance(const StepInput<R>& in) {
  const Vec<R> zero = all(R(0)), one = all(R(1));
  const Vec<R> least_stiffness = all(static_cast<R>(kLeastStiffness_n_per_mm));
  const Vec<R> per_mass = all(R(1) / in.mass_share);
  const Vec<R> longest2 = all(in.longest_move_mm * in.longest_move_mm);
  Vec<R> force2 = zero, move2 = zero, step_share2 = zero, listed_share2 = zero;
  for (int b = 0; b < in.block_count; ++b) {
    NodeBlock<R>& block = in.blocks[b];
    const Vec3x<R> x = xyz(load_quads(in.x + kLanes * b));
    const Vec4x<R> pushed = load_quads(in.force + kLanes * b);
    store_quads(Vec4x<R>{zero, zero, zero, zero}, in.force + kLanes * b);
    Vec3x<R> force = xyz(pushed);
    Vec<R> stiffness = pushed.w;
    for (int s = 0; s < block.corners; ++s) {
      const Vec4x<R> pulled = gather(in.corners, in.corner_slots[block.first_corner + s]);
      force = force + xyz(pulled);
      stiffness = stiffness + pulled.w;
    }
    for (int s = 0; s < block.springs; ++s) {
      const SpringSlot<R>& slot = in.spring_slots[block.first_spring + s];
      const Vec3x<R> d = xyz(gather(in.x, slot.neighbour)) - x;
      const Vec<R> length2 = dot(d, d) + all(kTiny_mm2<R>);
      const Vec<R> inverse = inverse_sqrt(length2);
      const Vec<R> length = length2 * inverse;
      const Vec<R> knee = load(slot.knee_mm), pre = load(slot.pre_n_per_mm),
                   extra = load(slot.extra_n_per_mm);
      const Vec<R> pull =
          (pre * (length - load(slot.rest_mm)) + extra * largest(length - knee, zero)) * inverse;
      force = force + pull * d;
      const Vec<R> tangent = pre + select(knee < length + all(in.lookahead_mm), extra, zero);
      stiffness = stiffness + largest(tangent, magnitude(pull));
    }
    const Vec<R> free = load(block.free);
    force = free * force;
    force2 = force2 + dot(force, force);
    // Mass goes with stiffness. A node that becomes heavier keeps its momentum, not its speed: else
    // the knee of the springs would feed it energy.
    const Vec<R> held = largest(stiffness, least_stiffness);
    if (in.sums != nullptr)
      store_quads(Vec4x<R>{force.x, force.y, force.z, held}, in.sums + kLanes * b);
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
    const Vec4x<R> listed = load_quads(in.listed + kLanes * b);
    const Vec3x<R> moved = next - xyz(listed);
    const Vec<R> per_margin2 = free / (listed.w * listed.w);
    step_share2 = largest(per_margin2 * dot(v, v), step_share2);
    listed_share2 = largest(per_margin2 * dot(moved, moved), listed_share2);
  }
  return {sum(force2), static_cast<double>(largest_of(move2)),
          static_cast<double>(largest_of(step_share2)),
          static_cast<double>(largest_of(listed_share2))};
}
