"""Simulations that their owner advances."""

import math
import os
import pickle

import pytest

import linkwright


def test_a_push_by_the_owner(oscillator):
    simulation = oscillator.simulation(t_end=10, rtol=1e-12)
    simulation.advance_to(math.pi / 4)
    assert simulation.positions[0] == pytest.approx(0.1 * math.cos(math.pi / 2), abs=1e-10)
    assert simulation.events in ([], [("middle", pytest.approx(math.pi / 4, abs=1e-9))])
    assert simulation.time == math.pi / 4
    simulation.set_input("F", "0.8 N")
    # From x = 0 with speed -0.2 m/s about the new middle at 0.1 m, for half a turn.
    simulation.advance_to(math.pi / 4 + math.pi / 2)
    assert simulation.positions[0] == pytest.approx(0.2, abs=1e-9)
    assert simulation.accelerations[0] == pytest.approx((0.8 - 8 * 0.2) / 2, abs=1e-8)
    assert simulation.multipliers.shape == (0,) and not simulation.has_ended


def test_saved_simulations_continue_with_the_same_bits(quick_return):
    first = quick_return.simulation(t_end=1)
    first.advance_to(0.3)
    saved = first.save()
    first.advance_to(0.6)
    second = quick_return.simulation(t_end=1)
    second.restore(saved)
    second.advance_to(0.6)
    assert (first.positions == second.positions).all() and first.time == second.time == 0.6
    with pytest.raises(linkwright.ArgumentError, match="damaged"):
        second.restore(saved[:-3])
    while second.step():
        pass
    assert second.has_ended and second.time == 1


def test_parameters_change_on_the_way(quick_return):
    simulation = quick_return.simulation(t_end=1)
    simulation.advance_to(0.1)
    simulation.set_parameter("O2A", "151 mm")
    assert abs(quick_return.with_values({"O2A": "151 mm"}).constraints(simulation.time, simulation.positions)).max() < 1e-12
    with pytest.raises(linkwright.ArgumentError, match="no parameter is called `O2B`"):
        simulation.set_parameter("O2B", 1)


def test_the_end_is_not_passed_without_a_word(oscillator):
    simulation = oscillator.simulation(t_end=1)
    assert simulation.t_end == 1 and simulation.advance_to(0.5)
    for time in (0.4, 1.5, math.nan):
        with pytest.raises(linkwright.ArgumentError, match="is needed; `t_end` sets the end"):
            simulation.advance_to(time)
    assert simulation.time == 0.5 and simulation.advance_to(1) and simulation.has_ended
    stopped = oscillator.simulation(t_end=2, until="middle")
    assert stopped.advance_to(2) is False and stopped.time == pytest.approx(math.pi / 4, abs=1e-9)
    with pytest.raises(TypeError, match="save"):
        pickle.dumps(stopped)


def test_large_mechanisms_are_saved_too():
    """Their vectors do not fit on a usual stack. A mass on a spring is the closed form."""
    model = linkwright.load("""pub Chain; parameters { k [N/m] = 100; }
        repeat i in 1..=70 { coordinates { x_[i] [m]; } bodies { m_[i]: mass 1 [kg] at [x_[i], 0]; }
                             loads { spring k, rest 0 [m] on x_[i]; } }
        initial { x_1 = 1; }""")
    first, second = (model.simulation(t_end=1, rtol=1e-12) for _ in range(2))
    first.advance_to(0.5)
    second.restore(first.save())
    assert first.advance_to(1) and second.advance_to(1)
    assert (first.positions == second.positions).all() and first.positions[0] == pytest.approx(math.cos(10), abs=1e-9)
    assert first.events == [] and first.accelerations[0] == pytest.approx(-100 * math.cos(10), abs=1e-6)


DROP = """
/// A ball that falls on a floor and stays there.
pub Drop;
coordinates { x [m]; y [m]; }
parameters { m [kg] = 2; g [m/s^2] = 9.81; }
inputs { F [N] = 0; }
bodies { ball: mass m at [x, y]; }
loads { gravity [0, -g]; force [F, 0] at [x, y]; }
constraints { floor: y = 0 initially released; }
initial { x = 0; y = 0.2 [m]; dot(x) = 0; dot(y) = 0; }
events { landing: y = 0 falling { activate floor; } }
outputs { push [N] = -reaction(floor); }
"""


def test_the_model_of_a_simulation_is_the_mechanism_as_it_is_now():
    model = linkwright.load(DROP)
    simulation = model.simulation(t_end=1)
    simulation.set_parameter("m", 3)
    simulation.set_input("F", 6)
    simulation.advance_to(0.1)
    assert simulation.model.parameters["m"] == 3 and simulation.model.inputs == {"F": 6}
    assert model.parameters["m"] == 2 and model.inputs == {"F": None}

    def accelerations(of):
        return of.dynamics(simulation.time, simulation.positions, simulation.speeds)[0]

    assert accelerations(simulation.model) == pytest.approx([2, -9.81])
    simulation.advance_to(0.5)
    now = simulation.model
    # It lies on the floor, which its mass presses on.
    for of in (now, pickle.loads(pickle.dumps(now)), now.with_values({"m": 3})):
        assert accelerations(of) == pytest.approx([2, 0])
        state = (simulation.positions, simulation.speeds, simulation.accelerations, simulation.multipliers)
        assert abs(of.outputs(simulation.time, *state)) == pytest.approx([3 * 9.81])
    assert accelerations(model) == pytest.approx([0, -9.81])
    # A run begins in the air.
    fallen = now.run(t_end=0.1)["y"]
    assert fallen[-1] == pytest.approx(0.2 - 9.81 * 0.1**2 / 2, rel=1e-9)


@pytest.mark.parametrize("time", ["0.1 s", None, [0.1], float("nan"), 10**400])
def test_what_is_no_time_is_refused(oscillator, time):
    with pytest.raises(linkwright.ArgumentError):
        oscillator.simulation(t_end=1).advance_to(time)


def test_saved_bytes_may_be_of_any_kind(oscillator):
    simulation = oscillator.simulation(t_end=1)
    simulation.advance_to(0.3)
    saved = simulation.save()
    for kind in (bytes, bytearray, memoryview):
        other = oscillator.simulation(t_end=1)
        other.restore(kind(saved))
        assert other.time == 0.3
    with pytest.raises(linkwright.ArgumentError, match="the bytes that `save"):
        simulation.restore("saved")


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="memory is read from /proc")
def test_inputs_that_are_set_often_take_no_memory(oscillator):
    def resident():
        with open("/proc/self/statm") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

    simulation = oscillator.simulation()
    for count in (2000, 40_000):
        before = resident()
        for _ in range(count):
            simulation.set_input("F", "1 mN")
            simulation.set_parameter("m", 2)
        grown = resident() - before
    # A tenth of what a text kept by each call would take.
    assert grown < 400_000
