"""Many valves with many plans."""

import itertools
import threading
import unittest

import coapt
from client_runs import VALVE, ClientTest, both
from coapt import Plan, Ring
from coapt.sweep import Sweep
from programs import SOURCE

RING = SOURCE / "examples/plans/ring.json"


@both
class Closures(ClientTest):
    def test_closures_come_in_the_order_of_valves_then_plans(self):
        valves, plans = ["porcine-1", self.make("human-normal"), VALVE], [Plan(), RING]
        items = list(self.client.map(valves, plans, threads=4))
        self.assertEqual(
            [(item.valve_number, item.plan_number) for item in items], list(itertools.product(range(3), range(2)))
        )
        self.assertEqual({(item.valve_number, item.valve) for item in items}, set(enumerate(map(str, valves))))
        self.assertEqual([item.plan for item in items], ["plan 1", "ring"] * 3)
        for item, (valve, plan) in zip(items, itertools.product(valves, plans)):
            self.assertEqual(item.closure.measure, self.client.close(valve, plan).measure)
            self.assertTrue(item.trusted)

    def test_one_valve_and_no_plan_are_enough(self):
        (item,) = self.client.map(VALVE)
        self.assertEqual((item.valve, item.plan, item.closure.valve), (VALVE, "no repair", VALVE))

    def test_an_error_stands_in_its_place_and_the_others_go_on(self):
        impossible = Plan(Ring("generic-classic", 31))
        items = list(self.client.map(["nowhere.json", VALVE, "human-functionl-mr"], [RING, impossible]))
        self.assertEqual([item.trusted for item in items], [False, False, True, False, False, False])
        self.assertEqual([item.closure is None for item in items], [item.error is not None for item in items])
        self.assertEqual(
            [type(item.error) for item in items],
            2 * [coapt.NoSuchFile] + [type(None)] + 3 * [coapt.InvalidRequest],
        )
        self.assertIn("/plan/steps/0/size_mm", items[3].problem)
        self.assertIn(f'did you mean "{VALVE}"', items[4].problem)


class Ahead(unittest.TestCase):
    """How far a sweep runs before what was taken."""

    def setUp(self):
        self.read, self.closed = [], []

    def valves(self):
        for number in itertools.count():
            self.read.append(number)
            yield {"name": f"valve {number}"}

    def sweep(self, close, threads=3):
        return iter(Sweep(close, self.valves(), [("a", {}), ("b", {})], threads))

    def test_an_endless_sweep_is_two_closures_a_thread_ahead(self):
        sweep = self.sweep(lambda valve, plan: self.closed.append(valve))
        for taken in range(1, 10):
            item = next(sweep)
            self.assertEqual((item.valve_number, item.plan_number), divmod(taken - 1, 2))
            self.assertLessEqual(len(self.closed), taken + 2 * 3)
            self.assertLessEqual(len(self.read), (taken + 2 * 3 + 1) / 2 + 1)
        sweep.close()

    def test_leaving_ends_it(self):
        sweep = self.sweep(lambda valve, plan: self.closed.append(valve))
        next(sweep)
        sweep.close()
        self.assertEqual([thread.name for thread in threading.enumerate() if "ThreadPool" in thread.name], [])

    def test_an_error_of_the_program_is_raised(self):
        with self.assertRaises(ZeroDivisionError):
            next(self.sweep(lambda valve, plan: 1 / 0))


if __name__ == "__main__":
    unittest.main()
