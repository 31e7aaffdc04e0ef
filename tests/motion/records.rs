//! Which rows are kept of a run, and that they are the same however many there are.

use models::{BouncingBall, QuickReturn};
use sim::{Mechanism, Method, Rows, Run, Settings, StopAt, mechanism};
use tests::any_model::run_with;

mechanism! {
    /// A pendulum; it passes its lowest position every half period.
    pub Swing;
    coordinates { phi [rad]; }
    parameters { m [kg] = 1; l [m] = 1; }
    bodies { bob: mass m at l*[sin(phi), -cos(phi)]; }
    loads { gravity [0, -9.81 [m/s^2]]; }
    initial { phi = 1; }
    events { lowest: phi = 0; }
}

/// The bits of all numbers of a sample.
fn bits<M: Mechanism>(run: &Run<M>, row: usize) -> Vec<u64> {
    let sample = &run.trajectory.samples[row];
    let (q, qd) = (sample.state.positions.as_ref(), sample.state.speeds.as_ref());
    let (qdd, lambda) = (sample.accelerations.as_ref(), sample.multipliers.as_ref());
    let others = [sample.state.time, sample.state.work, sample.power];
    [q, qd, qdd, lambda, &others].concat().iter().map(|value| value.to_bits()).collect()
}

/// Of a run that comes to its end exactly the rows asked for, with the same bits as among many more.
#[test]
fn a_finished_run_has_the_rows_asked_for() {
    let all = |settings: Settings| {
        let run = |rows| run_with(QuickReturn::default(), &Settings { rows: Rows::Even(rows), ..settings }).unwrap();
        let many = run(8192);
        // 107 steps: with 4 intervals rows lie closer at first, with 256 they need not.
        for rows in [1, 4, 32, 256] {
            let few = run(rows);
            assert_eq!(few.trajectory.samples.len(), rows + 1);
            for row in 0..=rows {
                assert_eq!(bits(&few, row), bits(&many, row * (8192 / rows)), "{rows}: {row}");
            }
            assert_eq!(few.steps, many.steps);
        }
        run(4).evaluations
    };
    all(Settings::adaptive(Method::Dop853, 2.0, 1e-9));
    all(Settings::adaptive(Method::Dopri5, 2.0, 1e-9));
    // Rows of equal steps stand where steps end: 4 stages of each step, the start, and the projected end of each, no more.
    assert_eq!(all(Settings::equal_steps(Method::Rk4, 2.0, 8192)), 4 * 8192 + 1);
}

/// A run that ends before its time, here by an event, has from N to 2N rows at equal intervals, and its last state; each row is
/// that of a run that records so densely to the same end.
#[test]
fn a_run_that_ends_early_keeps_rows_to_its_end() {
    for (end, asked, occurrence) in [(1e6, 10, 60), (1e4, 7, 37), (300.0, 25, 100), (1e5, 1, 8)] {
        let stop = Some(StopAt { event: 0, occurrence });
        let run = |rows, end| {
            let settings = Settings { stop, rows: Rows::Even(rows), ..Settings::adaptive(Method::Dop853, end, 1e-9) };
            run_with(Swing::default(), &settings).unwrap()
        };
        let found = run(asked, end);
        // So many steps that there are enough of them for each row.
        assert!(found.steps.accepted as usize > 8 * asked, "{:?}", found.steps);
        let times: Vec<f64> = found.trajectory.samples.iter().map(|sample| sample.state.time).collect();
        let (last, grid) = times.split_last().unwrap();
        assert_eq!(*last, found.events.last().unwrap().state.time);
        assert!((asked..=2 * asked).contains(&(grid.len() - 1)), "{} rows of {asked}", grid.len());
        let halvings = (end / asked as f64 / grid[1]).log2();
        // The interval is known to an ulp.
        assert!((halvings - halvings.round()).abs() < 1e-12, "{halvings}");
        assert!(grid.iter().enumerate().all(|(i, time)| (time - i as f64 * grid[1]).abs() <= 1e-12 * time));
        let densely = run(asked << halvings.round() as u32, end);
        assert_eq!(densely.steps, found.steps);
        let many = &densely.trajectory.samples;
        for (row, time) in times.iter().enumerate() {
            let same = many.iter().position(|sample| sample.state.time == *time).unwrap();
            assert_eq!(bits(&found, row), bits(&densely, same), "{time}");
        }
    }
}

/// States before and after an event stay, whatever rows between are dropped, and each phase begins where it did.
#[test]
fn rows_at_events_stay() {
    let stop = Some(StopAt { event: 0, occurrence: 6 });
    let run = |rows| {
        let settings = Settings { stop, rows: Rows::Even(rows), ..Settings::adaptive(Method::Dop853, 1e5, 1e-10) };
        run_with(BouncingBall::default(), &settings).unwrap()
    };
    for rows in [1, 3, 20] {
        let run = run(rows);
        let phases: Vec<f64> =
            run.trajectory.phases.iter().map(|phase| run.trajectory.samples[phase.first].state.time).collect();
        let bounces = run.events.iter().filter(|event| event.change.is_some()).map(|event| event.state.time);
        assert_eq!(phases[1..], bounces.take(phases.len() - 1).collect::<Vec<_>>());
        for phase in &run.trajectory.phases[1..] {
            let [before, after] = [phase.first - 1, phase.first].map(|row| &run.trajectory.samples[row].state);
            assert_eq!(before.time, after.time);
            assert!(before.speeds[1] < 0.0 && after.speeds[1] > 0.0, "{before:?} {after:?}");
        }
    }
}
