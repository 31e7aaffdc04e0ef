"""What a call from Python costs over the kernel.

A call of an array of states is timed against calls of one, and both against the kernel alone, which `sim` times in Rust:
`figures -- files` prints those. Here the cost of the call is what is left when nothing is computed: an oscillator's
dynamics take a few nanoseconds. Minimum of many repetitions, as machines are shared.
"""

import timeit

import numpy as np

import linkwright

TRIVIAL = "pub Mass; coordinates { x [m]; } parameters { m [kg] = 1; } bodies { b: mass m at [x, 0]; }"
STATES = 10_000


def seconds(call, number):
    return min(timeit.repeat(call, number=number, repeat=15)) / number


def one(name, model):
    q, qd = model.initial()
    return name, 1e9 * seconds(lambda: model.dynamics(0.0, q, qd), 5000), "ns a call"


def many(name, model):
    q, qd = (np.tile(numbers, (STATES, 1)) for numbers in model.initial())
    return name, 1e9 / STATES * seconds(lambda: model.dynamics(0.0, q, qd), 20), "ns a state"


def main():
    trivial, quick_return = linkwright.load(TRIVIAL), linkwright.load("quick-return")
    for name, figure, unit in [
        (*one("one state, hardly a kernel (bound 1000)", trivial),),
        (*one("one state of quick-return", quick_return),),
        (*many("10,000 states, hardly a kernel", trivial),),
        (*many("10,000 states of quick-return (bound 30)", quick_return),),
    ]:
        print(f"{name:<48} {figure:9.1f} {unit}")


if __name__ == "__main__":
    main()
