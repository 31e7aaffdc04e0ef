//! The column of the work that loads and drives have done.

use models::BouncingBall;
use sim::{Column, Compiled, Mechanism, Method, Rows, Run, Settings, Table, mechanism};
use tests::any_model::{self, AnyModel, interpreted};
use tests::run_with;

mechanism! {
    /// A sledge on a spring, pushed by a constant force, with a mass on it that a motor drags to and fro across.
    pub Sledge;
    coordinates { x [mm]; }
    parameters { m [kg] = 2; F [N] = 3; k [N/m] = 50; b [m] = 0.1; }
    bodies {
        sledge: mass m at [x, 0];
        dragged: mass m at [b*sin(t/(1 [s])), x];
    }
    loads { force [0, F - k*x] at [0, x]; }
    initial { dot(x) = 400; }
}

mechanism! {
    /// A sledge with an output that is called as the column is.
    pub WithOutput;
    coordinates { x [m]; }
    parameters { m [kg] = 2; F [N] = 3; }
    bodies { sledge: mass m at [x, 0]; }
    loads { force [F, 0] at [x, 0]; }
    outputs { work [kJ] = F*x; }
}

mechanism! {
    /// A sledge whose place is called so.
    pub WithCoordinate;
    coordinates { work [m]; }
    parameters { m [kg] = 2; F [N] = 3; }
    bodies { sledge: mass m at [work, 0]; }
    loads { force [F, 0] at [work, 0]; }
}

fn run<M: Compiled>(end: f64) -> (Run<AnyModel>, Table) {
    let settings = Settings::adaptive(Method::Dop853, end, 1e-10);
    let run = any_model::run_with(M::defaults(), &settings).unwrap();
    let table = Table::of(&run.mechanism, &run.trajectory);
    (run, table)
}

fn names(table: &Table) -> Vec<String> {
    table.columns.iter().map(Column::header).collect()
}

/// Forces do F x - k x^2/2, and a motor that makes a mass move by b sin t the change of m (b cos t)^2/2.
#[test]
fn the_column_is_the_work_of_loads_and_drives() {
    let (_, table) = run::<Sledge>(3.0);
    assert_eq!(names(&table), ["t [s]", "x [mm]", "x_dot [mm/s]", "x_ddot [mm/s^2]", "work [J]"]);
    let [x, work] = ["x", "work"].map(|name| &table.column(name).unwrap().values);
    assert!(work.len() > 100 && work[0] == 0.0);
    for ((t, x), work) in table.times().iter().zip(x).zip(work) {
        let x = x / 1000.0;
        let expected = 3.0 * x - 25.0 * x * x + 0.1f64.powi(2) * (t.cos().powi(2) - 1.0);
        // Of 1 J, by a tolerance of 1e-10.
        assert!((work - expected).abs() < 1e-9, "{t}: {work} {expected}");
    }
}

/// Kinetic energy changes by the work less what impacts take.
#[test]
fn impacts_do_no_work() {
    let (run, table) = run::<BouncingBall>(2.0);
    let work = &table.column("work").unwrap().values;
    let kinetic = |row: usize| {
        let state = &run.trajectory.samples[row].state;
        run.mechanism.kinetic_energy(state.time, &state.positions, &state.speeds)
    };
    let change = kinetic(work.len() - 1) - kinetic(0);
    let size = work.iter().fold(0.0f64, |size, work| size.max(work.abs()));
    assert!(run.energy_taken > 0.1 * size, "{} {size}", run.energy_taken);
    // By a tolerance of 1e-10.
    assert!((work[work.len() - 1] - run.energy_taken - change).abs() < 1e-8 * size, "{change}");
}

/// What a declaration calls `work` keeps its name and its numbers.
#[test]
fn the_column_has_a_name_of_its_own() {
    let apart = |table: &Table, declared: &str, force: f64| {
        let [own, declared] = ["work-done", declared].map(|name| &table.column(name).unwrap().values);
        own.iter().zip(declared).fold(0.0f64, |apart, (own, x)| apart.max((own - force * x).abs()))
    };
    let (_, table) = run::<WithOutput>(1.0);
    assert_eq!(names(&table), ["t [s]", "x [m]", "x_dot [m/s]", "x_ddot [m/s^2]", "work-done [J]", "work [kJ]"]);
    assert_eq!(table.outputs().iter().map(|column| column.name.as_str()).collect::<Vec<_>>(), ["work"]);
    // Of 2 J, by a tolerance of 1e-10.
    assert!(apart(&table, "work", 1000.0) < 1e-9);
    let (_, table) = run::<WithCoordinate>(1.0);
    assert_eq!(names(&table)[1..], ["work [m]", "work_dot [m/s]", "work_ddot [m/s^2]", "work-done [J]"]);
    assert!(apart(&table, "work", 3.0) < 1e-9);
}

mechanism! {
    /// A ball on a spring that stiffens, and a clock that counts its ticks.
    pub Counted;
    coordinates { x [m]; }
    parameters { m [kg] = 1; k [N/m] = 40; w [1/s] = 3; count = 0; }
    bodies { ball: mass m at [x, 0]; }
    loads { spring k*stretch + 10 [1/m^2]*k*stretch^3, rest 0 [m] on x; }
    events { tick: sin(w*t) = 0 rising { set count = count + 1; } }
    initial { x = 0.5; dot(x) = 0.2; }
}

/// After each event the motion starts anew from a state inside a step. The work until then is that of the spring,
/// -k (x^2/2 + 10 x^4/4), as accurate as the steps, whether none or nearly all have an event.
#[test]
fn events_inside_steps_keep_the_work() {
    let potential = |x: f64| 40.0 * (x * x / 2.0 + 2.5 * x.powi(4));
    let energy = potential(0.5) + 0.02;
    for method in [Method::Dopri5, Method::Radau5, Method::Dop853] {
        for (w, tolerance) in [0.1, 3.0, 300.0].into_iter().flat_map(|w| [1e-6, 1e-8, 1e-10, 1e-11].map(|t| (w, t))) {
            let settings = Settings { rows: Rows::Steps, ..Settings::adaptive(method, 5.0, tolerance) };
            let run = any_model::run_with(Counted { w, ..Counted::default() }, &settings).unwrap();
            let states = run.trajectory.samples.iter().map(|sample| &sample.state);
            let off = states.map(|state| (state.work + potential(state.positions[0]) - potential(0.5)).abs() / energy);
            let worst = off.fold(run.energy_balance, f64::max);
            // Some tolerances for all steps together, and one half for each of up to 238 events.
            let bound = (30.0 + run.events.len() as f64 / 2.0) * tolerance;
            assert!(worst < bound, "{method:?}, {w}, {tolerance:e}: {worst:e} after {} events", run.events.len());
        }
    }
}

/// Positions and speeds that are polynomials of time are integrated without error, the first up to the whole run in one step; the
/// power has twice their degree. The block ends with m v^2/2, at v = F0 t^(k + 1)/((k + 1) m).
#[test]
fn work_of_polynomials_of_time_is_right() {
    let (end, tolerance) = (2.0_f64, 1e-10);
    for (k, unit, mass) in (1..=6).flat_map(|k| [(k, "m", 2.0), (k, "mm", 2e-3)]) {
        let size = if unit == "mm" { 1e-6 } else { 1.0 };
        let declaration = format!(
            "pub Pushed; coordinates {{ x [{unit}]; }} parameters {{ m [kg] = {mass}; F [N/s^{k}] = {}; b [{unit}] = 1; }}
             bodies {{ block: mass m at [b + x, 0]; }} loads {{ force [F*t^{k}, 0] at [b + x, 0]; }}",
            4.0 * size
        );
        let work = |t: f64| (4.0 * size * t.powi(k + 1) / f64::from(k + 1)).powi(2) / (2.0 * mass);
        for method in [Method::Dopri5, Method::Radau5, Method::Dop853] {
            let settings = Settings { rows: Rows::Even(8), ..Settings::adaptive(method, end, tolerance) };
            let run = run_with(interpreted(&declaration).unwrap(), &settings).unwrap();
            for state in run.trajectory.samples.iter().map(|sample| &sample.state) {
                let off = (state.work - work(state.time)).abs() / work(end);
                // Some tolerances of speeds, in a power of high degree.
                assert!(off < 30.0 * tolerance, "t^{k} in {unit} by {method:?} at {}: {off:e}", state.time);
            }
        }
    }
}
