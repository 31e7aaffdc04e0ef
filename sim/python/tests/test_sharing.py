"""Threads, processes and interruption."""

import concurrent.futures
import os
import pickle
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import linkwright


#: More coordinates than fit on a usual stack.
CHAIN = """pub Chain; parameters { k [N/m] = 100; }
repeat i in 1..=70 { coordinates { x_[i] [m]; } bodies { m_[i]: mass 1 [kg] at [x_[i], 0]; } loads { spring k, rest 0 [m] on x_[i]; } }
initial { x_1 = 1; }"""


def last(model):
    return model.run(t_end=0.1)["alpha"][-1]


def test_models_travel(quick_return):
    other = pickle.loads(pickle.dumps(quick_return.with_values({"O2A": "140 mm"}, None)))
    assert other.parameters == quick_return.with_values({"O2A": "140 mm"}).parameters
    assert other.declaration_hash == quick_return.declaration_hash and last(other) != last(quick_return)
    run = quick_return.run(t_end=0.1)
    assert pickle.loads(pickle.dumps(run)).report() is None and "<canvas" in run.report()
    again = pickle.loads(pickle.dumps(run))
    assert again["alpha"][-1] == last(quick_return) and again.report() == run.report()


def test_errors_travel():
    with pytest.raises(linkwright.DeclarationError) as raised:
        linkwright.load("pub A; {")
    error = pickle.loads(pickle.dumps(raised.value))
    assert error.mistakes == raised.value.mistakes and error.place == raised.value.place
    assert str(error) == str(raised.value) and error.code == raised.value.code


def test_threads_and_processes_agree(quick_return):
    models = [quick_return.with_values({"O2A": 0.14 + 0.001 * k}) for k in range(8)]
    expected = [last(model) for model in models]
    with concurrent.futures.ThreadPoolExecutor(4) as threads:
        assert list(threads.map(last, models)) == expected
    context = __import__("multiprocessing").get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(2, mp_context=context) as processes:
        assert list(processes.map(last, models)) == expected


@pytest.mark.skipif(os.name == "nt", reason="signals of POSIX")
@pytest.mark.parametrize(
    "work",
    [
        "m.run(t_end=1e6, rtol=1e-12, rows=2)",
        "m.simulation(t_end=1e6, rtol=1e-12).advance_to(1e6)",
        "m.kinematics('alpha', start=0, to=4e5, steps=10_000_000)",
        "m.linearize(at=1e6)",
        "linkwright.load(CHAIN).simulation(t_end=1e6, rtol=1e-12).advance_to(1e6)",
    ],
)
def test_ctrl_c_ends_work(work):
    # What starts the tests may have told them to ignore signals.
    heard = "import signal\nsignal.signal(signal.SIGINT, signal.default_int_handler)"
    program = f"{heard}\nimport linkwright\nCHAIN = {CHAIN!r}\nm = linkwright.load('quick-return')\nprint('begins', flush=True)\n{work}\nprint('over')"
    process = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "begins\n"
    time.sleep(0.5)
    process.send_signal(signal.SIGINT)
    out, errors = process.communicate(timeout=20)
    assert "KeyboardInterrupt" in errors and out == "" and process.returncode != 0


def test_handlers_of_signals_may_look_at_a_simulation(oscillator):
    simulation, seen = oscillator.simulation(t_end=1e6, rtol=1e-12), []

    def look(*_):
        seen.append((simulation.time, len(simulation.save())))
        if len(seen) == 3:
            raise TimeoutError

    before = signal.signal(signal.SIGALRM, look)
    signal.setitimer(signal.ITIMER_REAL, 0.1, 0.1)
    try:
        with pytest.raises(TimeoutError):
            simulation.advance_to(1e6)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert 0 < seen[0][0] < seen[2][0] <= simulation.time < 1e6


def test_failures_travel_with_what_was_computed():
    text = "pub Root; coordinates { x [m]; } parameters { m [kg] = 1; } bodies { b: mass m at [x, 0]; }\n" \
           "loads { force [-sqrt(x*1 [1/m])*1 [N], 0] at [x, 0]; } initial { x = 1; dot(x) = -2; }"
    with pytest.raises(linkwright.MotionError) as raised:
        linkwright.load(text).run(t_end=5)
    error = pickle.loads(pickle.dumps(raised.value))
    assert np.array_equal(error.result.t, raised.value.result.t) and error.time == raised.value.time


def test_the_lock_is_released(quick_return):
    """While a thread runs a motion, another one counts."""
    with concurrent.futures.ThreadPoolExecutor(1) as threads:
        running = threads.submit(quick_return.run, t_end=50, rows=2)
        count = 0
        while not running.done():
            count += 1
            time.sleep(0.001)
        assert running.result().t[-1] == 50 and count > 3


def test_columns_are_not_copied(quick_return):
    run = quick_return.run(t_end=0.1)
    frame_memory = run.to_pandas()["alpha"].to_numpy()
    assert np.shares_memory(frame_memory, run["alpha"])
