"""What calls from Python cost.

The first figure is the cost of a call itself, as the kernel of a single mass takes a few nanoseconds. Minimum of many
repetitions, as machines are shared.
"""

import timeit

import numpy as np

import linkwright

MASS = "pub Mass; coordinates { x [m]; } parameters { m [kg] = 1; } bodies { b: mass m at [x, 0]; }"
STATES = 10_000


def nanoseconds(call, number):
    return 1e9 * min(timeit.repeat(call, number=number, repeat=15)) / number


def one(model):
    q, qd = model.initial()
    return nanoseconds(lambda: model.dynamics(0.0, q, qd), 5000)


def many(model):
    q, qd = (np.tile(numbers, (STATES, 1)) for numbers in model.initial())
    return nanoseconds(lambda: model.dynamics(0.0, q, qd), 20) / STATES


def main():
    mass, quick_return = linkwright.load(MASS), linkwright.load("quick-return")
    print(f"dynamics of one mass, in ns a call: {one(mass):.0f}")
    print(f"dynamics of quick-return, in ns a call: {one(quick_return):.0f}")
    print(f"dynamics of quick-return at {STATES} states, in ns a state: {many(quick_return):.1f}")


if __name__ == "__main__":
    main()
