"""Sobol indices, least squares, decision trees, ability and difficulty against numpy, scipy and scikit-learn. The Gaussian process of
the search is beside its binding, in tests/python/test_spaces.py."""

import importlib.util
import json
import os
import subprocess
import unittest

MISSING = [name for name in ("numpy", "scipy", "sklearn") if importlib.util.find_spec(name) is None]
if not MISSING:
    import numpy
    from numpy.testing import assert_allclose
    from scipy import integrate, optimize, stats


def ask(name, question):
    run = subprocess.run(
        [os.environ["ORACLE_ANSWERS"]], input=json.dumps({name: question}), capture_output=True, text=True, check=True
    )
    return json.loads(run.stdout)


def right(ability, difficulty, chance, slope=1.0):
    """Birnbaum's model."""
    return chance + (1 - chance) / (1 + numpy.exp(-slope * (ability - difficulty)))


@unittest.skipIf(MISSING, f"needs {MISSING}")
class Oracles(unittest.TestCase):
    def setUp(self):
        self.chance = numpy.random.default_rng(7)

    def test_sobol_indices_are_the_variances_of_conditional_means(self):
        """Of a polynomial of second degree, integrated by Gauss's rule, which is exact for it."""
        a, b = self.chance.normal(size=3), self.chance.normal(size=(3, 3))

        def values(x):
            return 1.0 + x @ a + numpy.einsum("...i,ij,...j", x, b, x)

        nodes, weights = numpy.polynomial.legendre.leggauss(5)
        nodes, weights = (nodes + 1) / 2, weights / 2
        grid = values(numpy.stack(numpy.meshgrid(nodes, nodes, nodes, indexing="ij"), axis=-1))

        def mean(array, axes):
            for axis in sorted(axes, reverse=True):
                array = numpy.tensordot(array, weights, (axis, 0))
            return array

        def variance(array):
            every = range(array.ndim)
            return mean(array**2, every) - mean(array, every) ** 2

        shares = self.chance.random((60, 3))
        told = ask("sobol", {"shares": shares.tolist(), "values": values(shares).tolist()})
        others = [[k for k in range(3) if k != i] for i in range(3)]
        first = [variance(mean(grid, other)) / variance(grid) for other in others]
        total = [1 - variance(mean(grid, [i])) / variance(grid) for i in range(3)]
        assert_allclose(told["first"], first, atol=1e-9)
        assert_allclose(told["total"], total, atol=1e-9)

    def test_q2_is_that_of_leaving_one_out(self):
        from sklearn.linear_model import LinearRegression
        from sklearn.metrics import r2_score
        from sklearn.model_selection import LeaveOneOut, cross_val_predict
        from sklearn.preprocessing import PolynomialFeatures

        shares = self.chance.random((60, 3))
        values = numpy.sin(3 * shares[:, 0]) + shares[:, 1] * shares[:, 2] + 0.1 * self.chance.normal(size=60)
        squares = numpy.hstack([shares, shares**2])
        shares_left = []
        for terms in (shares, squares, PolynomialFeatures(2).fit_transform(shares)):
            shares_left.append(r2_score(values, cross_val_predict(LinearRegression(), terms, values, cv=LeaveOneOut())))
        told = ask("sobol", {"shares": shares.tolist(), "values": values.tolist()})
        self.assertAlmostEqual(told["q2"], max(shares_left), places=9)

    def test_least_squares_end_where_scipy_does(self):
        for number in range(6):
            weights, slopes = self.chance.normal(size=(2, 9, 3))
            truth = self.chance.uniform(
                -0.2 if number % 2 else 0.2, 1.2 if number % 2 else 0.8, 3
            )  # beyond a face, too

            def residuals(x):
                return (weights * numpy.tanh(slopes * x)).sum(axis=1) - targets

            targets = numpy.zeros(9)
            targets = residuals(truth) + 0.01 * self.chance.normal(size=9)
            found = optimize.least_squares(residuals, [0.5] * 3, bounds=(0, 1), xtol=1e-12, ftol=1e-12, gtol=1e-12)
            told = ask(
                "least_squares",
                {
                    "weights": weights.tolist(),
                    "slopes": slopes.tolist(),
                    "targets": targets.tolist(),
                    "start": [0.5] * 3,
                },
            )
            with self.subTest(number=number):
                assert_allclose(told["cost"], 2 * found.cost, rtol=1e-4)
                assert_allclose(told["point"], found.x, atol=2e-3)

    def test_a_tree_splits_where_scikit_learn_does(self):
        """The cost of the candidate that predicts c is (value - c)^2: with candidates enough it is the tree of least squares."""
        from sklearn.tree import DecisionTreeRegressor

        features = self.chance.random((80, 4))
        values = numpy.where(features[:, 1] > 0.6, 2.0, features[:, 2]) + 0.05 * self.chance.normal(size=80)
        costs = (values[:, None] - numpy.linspace(-0.5, 2.5, 3001)) ** 2
        told = ask(
            "tree",
            {"features": features.tolist(), "costs": costs.tolist(), "most_leaves": 6, "least_members": 5},
        )
        theirs = DecisionTreeRegressor(max_leaf_nodes=6, min_samples_leaf=5).fit(features, values).tree_
        split = theirs.children_left >= 0
        expected = zip(theirs.feature[split], theirs.threshold[split], theirs.n_node_samples[split])
        assert_allclose(sorted(told), sorted(map(list, expected)), rtol=1e-6)

    def test_ability_is_the_mean_and_sd_of_the_posterior(self):
        answers = [
            {"right": bool(self.chance.random() < 0.6), "difficulty": d, "chance": c, "slope": s}
            for d, c, s in zip(self.chance.normal(size=15), self.chance.choice([0.25, 1 / 3], 15), [0.7, 1.0, 1.4] * 5)
        ]

        def posterior(ability):
            ps = [right(ability, one["difficulty"], one["chance"], one["slope"]) for one in answers]
            likelihood = numpy.prod([p if one["right"] else 1 - p for p, one in zip(ps, answers)])
            return likelihood * stats.norm.pdf(ability, 0, 1.5)

        moments = [integrate.quad(lambda x: x**k * posterior(x), -12, 12, epsabs=1e-14)[0] for k in range(3)]
        mean = moments[1] / moments[0]
        told = ask("ability", answers)
        self.assertAlmostEqual(told["value"], mean, places=4)
        self.assertAlmostEqual(told["sd"], (moments[2] / moments[0] - mean**2) ** 0.5, places=4)

    def test_difficulties_are_those_of_the_likeliest_rasch_model(self):
        """Marginal over normal abilities by Gauss's and Hermite's rule, with the normal prior of difficulties, by scipy's BFGS."""
        truth, chance = numpy.linspace(-1.5, 1.5, 6), 0.25
        abilities = self.chance.normal(0, 1.5, 200)
        answers = self.chance.random((200, 6)) < right(abilities[:, None], truth, chance)
        nodes, weights = numpy.polynomial.hermite_e.hermegauss(60)

        def cost(difficulties):
            p = right(1.5 * nodes[:, None], difficulties, chance)
            likelihood = numpy.exp(answers @ numpy.log(p).T + ~answers @ numpy.log(1 - p).T)
            return -numpy.log(likelihood @ weights).sum() + (difficulties**2).sum() / (2 * 2.0**2)

        found = optimize.minimize(cost, numpy.zeros(6), method="BFGS", tol=1e-8)
        told = ask("calibration", {"right": answers.astype(int).tolist(), "chance": chance})
        assert_allclose(told, found.x, atol=2e-3)


if __name__ == "__main__":
    unittest.main()
