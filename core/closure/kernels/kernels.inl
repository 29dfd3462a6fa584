// The kernels, written once. Included by one source per instruction set, in an anonymous namespace.

#include "core/closure/kernels/motion.inl"
// after motion.inl, whose scatter they use
#include "core/closure/kernels/contact.inl"
#include "core/closure/kernels/hinges.inl"
#include "core/closure/kernels/pairs.inl"
#include "core/closure/kernels/sheets.inl"
// after sheets.inl, whose images of unit vectors it uses
#include "core/closure/kernels/exponential.inl"
// after both
#include "core/closure/kernels/faces.inl"
// after pairs.inl, whose boxes it uses
#include "core/closure/kernels/crossing.inl"

template <class R>
constexpr Kernels<R> kTable = {advance<R>,      pull_cables<R>,      turn_hinges<R>, pull_faces<R>,
                               push_faces<R>,   push_edges<R>,       box<R>,         list_pairs<R>,
                               number_pairs<R>, straddling_faces<R>, exponentials<R>};
