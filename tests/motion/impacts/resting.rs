//! Bodies that rest at what they strike, or hang on what may pull them, and are loaded only later.

use super::all_settings;
use sim::{Settings, What};
use tests::any_model::{AnyModel, interpreted};
use tests::run_with;

/// The loads begin at 0.5 s, at once or gently.
const SUDDEN: &str = "(if t > 0.5 [s] then 1 else 0)";
const GENTLE: &str = "max(0, t/(1 [s]) - 0.5)";

fn run(declared: &str, begins: &str, settings: &Settings) -> sim::Run<AnyModel> {
    let text = format!("pub Rests; {}", declared.replace("LATER", begins));
    run_with(interpreted(&text).unwrap(), settings).unwrap()
}

/// It does not go through: the run ends where it is pressed. Its place is known to rounding, on either side.
#[test]
fn what_is_pressed_against_its_stop_later_does_not_go_through() {
    let ball = |start: &str| {
        format!(
            "coordinates {{ y [m]; }} parameters {{ r [m] = 0.1; }} bodies {{ b: mass 1 [kg] at [0, y]; }}
            loads {{ force -5 [N]*LATER on y; }} constraints {{ floor: y = r initially released; }}
            initial {{ y = {start}; dot(y) = 0; }} events {{ landing: y = r falling {{ impact floor restitution 0.5; }} }}"
        )
    };
    let two = "coordinates { a [mm]; b [mm]; } bodies { one: mass 1 [kg] at [a, 0]; two: mass 2 [kg] at [b, 0]; }
        loads { force 5 [N]*LATER on a; } constraints { touch: b - a = 3 [mm] initially released; }
        initial { a = 0; b = 3; dot(a) = 0; dot(b) = 0; }
        events { hit: b - a = 3 [mm] falling { impact touch restitution 0.3; } }";
    for declared in [&ball("r"), &ball("r - 1e-17 [m]"), &ball("r + 1e-14 [m]"), two] {
        for begins in [SUDDEN, GENTLE] {
            for settings in all_settings(2.0) {
                let failure = run(declared, begins, &settings).trajectory.failure.unwrap();
                assert!(
                    matches!(failure.what, What::Accumulating { .. }),
                    "{declared} {}: {failure}",
                    settings.method.name()
                );
                // A gentle load of 5 N/s takes 0.17 ms to move 1 kg by the tolerance of constraints, 4e-12 m; equal steps take 20 ms.
                assert!((failure.time - 0.5).abs() < 0.021, "{declared}: {failure}");
            }
        }
    }
}

/// A rope that is just taut holds what is pulled later, as does a latch, and a magnet that nothing has pulled lets go then, at any size.
#[test]
fn what_is_pulled_later_is_held_or_let_go() {
    let rope = "constraints { rope: x = SIZE initially released; } initial { x = SIZE; dot(x) = 0; }
        events { taut: x = SIZE rising { impact rope restitution 0; activate rope; } }";
    let latch = "constraints { lock: x = SIZE initially released; } initial { x = SIZE; dot(x) = 0; }
        events { snap: x = SIZE rising { activate lock; } }";
    let magnet = "constraints { held: x = SIZE initially active; } initial { guess x = SIZE; }
        events { off: reaction(held) = 0 [N] rising { release held; } }";
    for (size, begins) in [1e-3, 1.0, 100.0].into_iter().flat_map(|size| [(size, SUDDEN), (size, GENTLE)]) {
        // 3 N for each metre for 1.5 s, or growing by 3 N/s.
        let free = if begins == SUDDEN { 1.5 * 1.5 * 1.5 } else { 1.5f64.powi(3) / 2.0 };
        for (declared, place) in [(rope, 1.0), (latch, 1.0), (magnet, 1.0 + free)] {
            let body = "coordinates { x [m]; } parameters { l [m] = 1; } bodies { b: mass 1 [kg] at [x, 0]; }
                loads { force 3 [N/m]*l*LATER on x; }";
            let declared =
                format!("{body} {declared}").replace("l [m] = 1", &format!("l [m] = {size}")).replace("SIZE", "l");
            let run = run(&declared, begins, &Settings::new(2.0));
            assert_eq!((run.trajectory.failure, run.events.len()), (None, 1), "{declared}");
            let found = run.trajectory.samples.last().unwrap().state.positions[0] / size;
            assert!((found - place).abs() < 1e-9, "{declared} {begins}: {found} for {place}");
        }
    }
}
