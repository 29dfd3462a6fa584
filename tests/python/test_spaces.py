"""A valve's plans as vectors: the search's own space, the protocols of optimisers, refusals, ask and tell, the rule of the ranking."""

import copy
import importlib.util
import itertools
import math
import pickle
import random
import unittest

import coapt
from client_runs import SMALL, VALVE, EngineTest, has_engine
from coapt import EdgeToEdge, Merits, OwnRing, PapillaryApproximation, Plan, Ring, TriangularResection, order_plans

ENGINE = has_engine()
if ENGINE:
    import numpy
    from coapt import _engine

REPAIRED = (VALVE, "human-p2-prolapse", "porcine-thesis-tables")
EVERYTHING = {
    "own_ring": True, "leaflet_resection": True, "edge_to_edge": True, "chordal_length_change": True, "chordal_excision": True,
    "chordal_transfer": True,
}  # fmt: skip


def installed(*packages):
    return unittest.skipUnless(all(map(importlib.util.find_spec, packages)), f"needs {packages}")


def tension_n(closure):
    return closure.measure.tension_max_n


@unittest.skipUnless(ENGINE, "no engine")
class Spaces(EngineTest):
    def setUp(self):
        super().setUp()
        self.valve = self.client.preset(VALVE)
        self.space = self.valve.space()

    def test_a_space_is_that_of_the_search(self):
        for name in REPAIRED:
            with self.subTest(valve=name):
                valve = self.client.preset(name)
                found = valve.search(**SMALL).result().json
                told = valve.space()._branches.values()
                points = sum(math.prod(one["count"] for one in branch["parameters"]) for branch in told)
                self.assertEqual((len(told), points), (found["branches"], found["plans_possible"]))

    def test_a_competent_valve_has_one_plan_and_says_why(self):
        space = self.client.preset("human-normal").space()
        self.assertEqual((space.names, space.plan([])), ((), Plan()))
        self.assertEqual(space.cut, (("all repairs", "the valve is competent"),))

    def test_a_plan_is_found_again_from_its_vector_and_the_other_way_round(self):
        for name, rules in itertools.product(REPAIRED, (None, EVERYTHING)):
            with self.subTest(valve=name, rules=rules):
                space = self.client.preset(name).space(rules=rules)
                for x in space.random(25, seed=2):
                    plan = space.plan(x)
                    self.assertEqual(space.plan(space.vector(plan)), plan)

    def test_every_vector_within_the_bounds_is_a_plan_or_a_combination_that_is_not_offered(self):
        chance = random.Random(1)
        lower, upper = self.space.get_bounds()
        for _ in range(100):
            self.space.plan([chance.uniform(*ends) for ends in zip(lower, upper)])
        self.space.plan(lower)
        self.space.plan(upper)
        space = self.client.preset("human-p2-prolapse").space(rules=EVERYTHING)
        reasons = set()
        for _ in range(100):
            try:
                space.plan([chance.uniform(*ends) for ends in zip(*space.get_bounds())])
            except coapt.InvalidRequest as error:
                reasons.add(error.problems[0].path)
                self.assertIn("is not offered: ring", str(error))
        self.assertEqual(reasons, {"/x"})

    def test_what_lies_outside_is_refused_with_its_place_and_range(self):
        x = self.space.start
        for wrong, path, message in (
            ([*x[:1], 11, *x[2:]], "/x/1", "posteromedial_movement_mm is 11, must be from 3 to 10"),
            ([*x[:-1], -1], "/x/7", "must be from 0 to 3"),
            ([math.nan, *x[1:]], "/x/0", "ring_size_mm is nan"),
            (x[1:], "/x", "has 7 numbers, must have 8"),
        ):
            error = self.refused(coapt.InvalidRequest, self.space.plan, wrong)
            self.assertEqual([problem.path for problem in error.problems], [path])
            self.assertIn(message, str(error))
            trial = self.space.evaluate(wrong)
            self.assertEqual((trial.value, trial.plan, self.space(wrong)), (math.inf, None, math.inf))
            self.assertIn(message, trial.reason)

    def test_what_no_number_comes_of_is_a_value_with_a_reason(self):
        none = self.space.problem(lambda closure: math.nan).evaluate(self.space.start)
        self.assertEqual((none.value, none.reason), (math.inf, "the objective is not a number"))

        def refuses(closure):
            raise coapt.NotFound(404, "no such thing")

        self.assertEqual(self.space.problem(refuses).evaluate(self.space.start).reason, "404 no such thing")
        with self.assertRaises(ZeroDivisionError):  # a fault of the caller's own
            self.space.problem(lambda closure: 1 / 0)(self.space.start)

    def test_steps_choose_the_operation_and_leave_its_numbers_free(self):
        space = self.valve.space(
            Ring("generic-classic", 30), PapillaryApproximation("posteromedial", 22, "saddle_peak")
        )
        self.assertEqual(space.names, ("ring_size_mm", "posteromedial_movement_mm"))
        self.assertEqual((space.integer, space.get_nix()), ((False, False), 0))
        self.assertEqual({type(step) for step in space.plan(space.upper).steps}, {Ring, PapillaryApproximation})
        self.assertEqual(self.valve.space(space.plan(space.upper)).names, space.names)
        # On request alone; what is asked for is.
        self.assertEqual(self.valve.space(OwnRing(2)).names, ("ring_sizes_below",))
        torn = self.client.preset("human-p2-prolapse")
        self.assertEqual(
            torn.space(Ring("generic-classic", 30), EdgeToEdge()).names, ("ring_size_mm", "leaflet_width_mm")
        )
        self.assertIn("leaflet_width_mm", torn.space(OwnRing(1), TriangularResection(10)).names)

    def test_rules_are_those_of_a_search(self):
        space = self.valve.space(
            fixed=Plan(Ring("generic-classic", 28)), forbidden=["papillary_approximation:annulus_point"]
        )
        self.assertEqual(space.names[0], "posteromedial_movement_mm")
        self.assertNotIn("annulus_point", space.choices["posteromedial"])
        self.assertIn(Ring("generic-classic", 28), space.plan(space.start).steps)
        for asked in ({"forbidden": ["nothing"]}, {"rules": {"most_movement_mm": 0}}, {"rules": {"nonsense": 1}}):
            with self.subTest(asked=asked):
                searched = self.problems(coapt.InvalidRequest, self.valve.search, **SMALL, **asked)
                self.assertEqual(
                    [
                        ("/search" + path, code)
                        for path, code in self.problems(coapt.InvalidRequest, self.valve.space, **asked)
                    ],
                    searched,
                )
        error = self.refused(coapt.InvalidRequest, self.valve.space, EdgeToEdge())
        self.assertEqual([problem.path for problem in error.problems], ["/plan"])

    def test_it_is_the_problem_of_pygmo(self):
        problem = self.space.problem(tension_n)
        lower, upper = problem.get_bounds()
        self.assertTrue(all(a < b for a, b in zip(lower, upper)))
        self.assertEqual(problem.integer, (False,) * 5 + (True,) * problem.get_nix())
        points = problem.random(3, seed=4)
        one_by_one = [problem.fitness(numpy.array(x))[0] for x in points]
        flat = problem.batch_fitness(numpy.array(points).ravel())
        self.assertEqual((flat.tolist(), flat.shape), (one_by_one, (3,)))
        self.assertEqual(problem.batch_fitness(points).tolist(), [[value] for value in one_by_one])
        for again in (copy.deepcopy(problem), pickle.loads(pickle.dumps(problem))):
            self.assertEqual(again, problem)
            self.assertEqual(again.fitness(points[0]), [one_by_one[0]])
        self.assertNotEqual(problem, self.space)

    @installed("scipy")
    def test_scipy_takes_its_bounds_and_integers(self):
        from scipy.optimize import Bounds, differential_evolution

        found = differential_evolution(
            self.space, Bounds(*self.space.get_bounds()), integrality=self.space.integer, popsize=1, maxiter=1, seed=1,
            polish=False,
        )  # fmt: skip
        self.assertEqual(found.fun, self.space(found.x))
        self.assertEqual([float(x) for x in found.x[5:]], [round(x) for x in found.x[5:]])

    @installed("openturns")
    def test_openturns_takes_it_as_a_function(self):
        import openturns

        space = self.space
        function = openturns.PythonFunction(len(space.names), 1, space.fitness, func_sample=space.batch_fitness)
        points = space.random(2)
        self.assertEqual([list(row) for row in function(points)], [space.fitness(x) for x in points])

    def test_threads_do_not_change_values(self):
        points = self.space.random(4)
        one, four = ([trial.value for trial in self.space.evaluate_many(points, threads=n)] for n in (1, 4))
        self.assertEqual(one, four)
        self.assertEqual(
            self.problems(coapt.InvalidRequest, self.space.evaluate_many, points, threads=-1),
            [("/threads", "out_of_range")],
        )


@unittest.skipUnless(ENGINE, "no engine")
class Searchers(EngineTest):
    """On values that take no closures: how far a plan's vector lies from one."""

    def setUp(self):
        super().setUp()
        self.space = self.client.preset(VALVE).space()
        self.goal = self.space.random(1, seed=9)[0]

    def worth(self, x):
        spans = [b - a for a, b in zip(*self.space.get_bounds())]
        return sum(abs(a - b) / span for a, b, span in zip(x, self.goal, spans))

    def run_of(self, searcher, rounds, count=6):
        for _ in range(rounds):
            points = searcher.ask(count)
            searcher.tell(points, map(self.worth, points))
        return searcher

    def test_it_finds_more_than_chance_does(self):
        found = [self.run_of(self.space.searcher(seed), 8).best[1] for seed in (1, 2)]
        chance = [min(map(self.worth, self.space.random(48, seed))) for seed in (1, 2)]
        self.assertLess(sum(found), sum(chance))

    def test_nothing_is_asked_twice_and_the_same_seed_asks_the_same(self):
        searcher = self.run_of(self.space.searcher(3), 4)
        plans = [repr(self.space.plan(x)) for x, _ in searcher.told]
        self.assertEqual(len(set(plans)), len(plans))
        self.assertEqual(self.run_of(self.space.searcher(3), 4).told, searcher.told)

    def test_pickled_it_goes_on_where_it_was(self):
        searcher = self.run_of(self.space.searcher(3), 3)
        again = pickle.loads(pickle.dumps(searcher))
        self.assertEqual(self.run_of(again, 2).told, self.run_of(searcher, 2).told)

    def test_refusals_and_a_space_that_is_used_up_are_no_trouble(self):
        space = self.client.preset(VALVE).space(OwnRing(2))
        searcher = space.searcher()
        points = searcher.ask(10)
        self.assertEqual(sorted(points), [(1.0,), (2.0,), (3.0,), (4.0,)])
        self.assertEqual(searcher.ask(), [])
        searcher.tell(points, [math.inf, math.nan, 2.0, 1.0])
        self.assertEqual(searcher.best, (points[3], 1.0))
        searcher = self.space.searcher()
        searcher.tell(points := searcher.ask(12), [math.inf] * 12)
        self.assertEqual(len(searcher.ask(3)), 3)
        with self.assertRaises(ValueError):
            searcher.tell(points, [1.0])


@unittest.skipUnless(ENGINE, "no engine")
class Rule(unittest.TestCase):
    def test_plans_come_in_the_order_of_the_rule(self):
        """docs/researcher/search.md: acceptable first, without warnings, that last longest, of alike ones the simplest."""
        plans = {
            "simple": Merits(steps=1, durability_mm=9.0),
            "longer, but alike": Merits(steps=2, durability_mm=10.5),
            "much shorter": Merits(steps=1, durability_mm=4.0),
            "warned of": Merits(steps=1, durability_mm=20.0, avoidable_warnings=1),
            "less likely": Merits(acceptable_probability=0.9, durability_mm=20.0),
            "stenotic": Merits(stenotic=True),
            "untrusted": Merits(trusted=False),
            "rejected": Merits(rejected=True),
        }
        names = list(plans)
        for seed in range(5):
            shuffled = random.Random(seed).sample(names, len(names))
            order = order_plans(plans[name] for name in shuffled)
            self.assertEqual([shuffled[place.index] for place in order], names)
            self.assertEqual([place.of_class for place in order][:3], [1, 1, 2])
        self.assertEqual(order_plans([Merits(cost=2.0), Merits(cost=1.0)], by_price=True)[0].index, 1)
        self.assertEqual(order_plans([]), [])

    def test_thresholds_are_arguments(self):
        two = [Merits(acceptable_probability=0.9, steps=1), Merits(acceptable_probability=0.96, steps=2)]
        self.assertEqual(order_plans(two)[0].index, 1)
        self.assertEqual(order_plans(two, acceptable=0.85)[0].index, 0)


@unittest.skipUnless(ENGINE, "no engine")
class Oracle(unittest.TestCase):
    @installed("sklearn")
    def test_the_gaussian_process_is_that_of_scikit_learn(self):
        from sklearn.gaussian_process import GaussianProcessRegressor
        from sklearn.gaussian_process.kernels import RBF

        chance = numpy.random.default_rng(1)
        places, at = 4 * chance.random((20, 3)), 4 * chance.random((7, 3))
        values, usual_sd, prior = numpy.sin(places).sum(axis=1), 0.7, 2.0
        likelihoods = {}
        for length, noise in itertools.product((1, 2, 3, 5, 8), (1e-4, 1e-2, 1e-1)):
            model = GaussianProcessRegressor(RBF(length), alpha=noise, optimizer=None).fit(
                places, values - values.mean()
            )
            explained = (values - values.mean()) @ model.alpha_
            variance = (explained + prior * usual_sd**2) / (len(values) + prior)
            determinant = numpy.log(numpy.diag(model.L_)).sum()
            likelihoods[-0.5 * (len(values) + prior) * math.log(variance) - determinant] = model, variance
        model, variance = likelihoods[max(likelihoods)]
        mean, sd = model.predict(at, return_std=True)
        told = _engine.guess(places.tolist(), values.tolist(), usual_sd, at.tolist())
        numpy.testing.assert_allclose(told[0], mean + values.mean(), rtol=1e-9)
        numpy.testing.assert_allclose(told[1], math.sqrt(variance) * sd, rtol=1e-6)


if __name__ == "__main__":
    unittest.main()
