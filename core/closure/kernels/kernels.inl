// The kernels, written once. Included by one source per instruction set, in an anonymous namespace.

#include "core/closure/kernels/motion.inl"
// after motion.inl, whose scatter they use
#include "core/closure/kernels/contact.inl"
#include "core/closure/kernels/pairs.inl"
#include "core/closure/kernels/sheets.inl"
// after sheets.inl, whose add_to_nodes it uses
#include "core/closure/kernels/hinges.inl"
// after sheets.inl, whose scatter it uses
#include "core/closure/kernels/exponential.inl"
// after pairs.inl, whose boxes it uses
#include "core/closure/kernels/crossing.inl"

template <class R>
constexpr Kernels<R> kTable = {
    advance<R>,          pull_cables<R>, pull_sheets<R>, turn_hinges<R>,  push_faces<R>,
    push_edges<R>,       box<R>,         list_pairs<R>,  number_pairs<R>, straddling_faces<R>,
    pull_exponential<R>, exponentials<R>};
