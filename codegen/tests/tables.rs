//! Tables against closed forms: what comes back exactly, how errors fall, what is continuous, and the oracle's own formulas.

#![allow(missing_docs, clippy::unwrap_used)]

use codegen::oracle::{Oracle, State};
use codegen::symbolic::Table;

type Law = fn(f64) -> f64;

/// The table with these words and rows.
fn table(words: &str, rows: &[(f64, f64)]) -> Table {
    let equations = codegen::equations(declaration(words, rows).parse().unwrap()).unwrap();
    equations.graph.tables()[0].clone()
}

fn declaration(words: &str, rows: &[(f64, f64)]) -> String {
    let rows: String = rows.iter().map(|(x, y)| format!("{x:?}, {y:?}; ")).collect();
    format!(
        "pub Tabled; coordinates {{ x; }} tables {{ f = {words} {{ {rows} }} }} bodies {{ p: mass 1 at [x, 0]; }}
         outputs {{ f0 = f(x); f1 = dot(f(x)); f2 = ddot(f(x)); }}"
    )
}

fn sampled(x: impl IntoIterator<Item = f64>, law: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    x.into_iter().map(|x| (x, law(x))).collect()
}

fn even(from: f64, to: f64, intervals: usize) -> Vec<f64> {
    (0..=intervals).map(|i| from + (to - from) * i as f64 / intervals as f64).collect()
}

const UNEVEN: [f64; 7] = [-2.0, -1.7, -0.4, 0.0, 1.1, 1.3, 2.9];

/// The largest error of a derivative between two places, of a law of size 1.
fn worst(table: &Table, order: u8, law: impl Fn(f64) -> f64, [from, to]: [f64; 2]) -> f64 {
    let error = |x: f64| (table.derivative(order, x) - law(x)).abs();
    even(from, to, 997).into_iter().map(error).fold(0.0, f64::max)
}

/// A cubic spline gives cubics back, with all derivatives; a line is given back by all.
#[test]
fn polynomials_of_their_degree_come_back() {
    let cubic: [Law; 4] =
        [|x| 0.3 - x + 0.5 * x * x - 0.2 * x * x * x, |x| -1.0 + x - 0.6 * x * x, |x| 1.0 - 1.2 * x, |_| -1.2];
    let spline = table("cubic", &sampled(UNEVEN, cubic[0]));
    for (order, law) in (0..).zip(cubic) {
        // Differences of order 3 of values of size 10, over intervals down to 0.2.
        assert!(worst(&spline, order, law, [-2.0, 2.9 - 1e-9]) < 1e-12, "{order}");
    }
    let parabola: [Law; 3] = [|x| 2.0 - x + 0.7 * x * x, |x| -1.0 + 1.4 * x, |_| 1.4];
    let three = table("cubic", &sampled([-1.0, 0.5, 0.7], parabola[0]));
    for (order, law) in (0..).zip(parabola) {
        assert!(worst(&three, order, law, [-1.0, 0.7 - 1e-9]) < 1e-13, "{order}");
    }
    let line: [Law; 3] = [|x| 2.0 - 0.3 * x, |_| -0.3, |_| 0.0];
    for words in ["linear, continued", "cubic, continued", "cubic, natural, continued", "monotone, continued"] {
        for rows in [&UNEVEN[..], &UNEVEN[..2]] {
            let table = table(words, &sampled(rows.iter().copied(), line[0]));
            for (order, law) in (0..).zip(line) {
                // Beyond the rows as well.
                assert!(worst(&table, order, law, [-5.0, 5.0]) < 1e-13, "{words} {order}");
            }
        }
    }
}

/// The errors of a law's tables fall with the fourth power of the interval, of their derivatives with one power less each;
/// those of lines with the second.
#[test]
fn errors_fall_at_the_order_of_the_method() {
    let sine: [Law; 4] = [f64::sin, f64::cos, |x| -x.sin(), |x| -x.cos()];
    let cosine: [Law; 4] = [f64::cos, |x| -x.sin(), |x| -x.cos(), f64::sin];
    let (pi, turn) = (std::f64::consts::PI, std::f64::consts::TAU);
    let cases: [(&str, [Law; 4], f64, &[f64]); 6] = [
        ("cubic, periodic", sine, turn, &[4.0, 3.0, 2.0, 1.0]),
        ("cubic, natural", sine, pi, &[4.0, 3.0, 2.0, 1.0]),
        ("cubic, clamped", cosine, pi, &[4.0, 3.0, 2.0, 1.0]),
        ("cubic", sine, 1.5, &[4.0, 3.0, 2.0, 1.0]),
        ("linear, periodic", sine, turn, &[2.0, 1.0]),
        // Between an extreme and its rows a monotone cubic cannot follow; elsewhere it is of a higher order.
        ("monotone", sine, 1.2, &[2.0, 1.0]),
    ];
    for (words, law, end, orders) in cases {
        let errors = [40, 80, 160].map(|intervals| {
            // The last row of a period is 2e-16 off the first, as sin(2 pi) is.
            let rows = sampled(even(0.0, end, intervals), law[0]);
            let table = table(words, &rows);
            (0..orders.len()).map(|order| worst(&table, order as u8, law[order], [0.0, end - 1e-9])).collect::<Vec<_>>()
        });
        for (order, expected) in orders.iter().enumerate() {
            let rates = [0, 1].map(|i| (errors[i][order] / errors[i + 1][order]).log2());
            println!("{words:<16} derivative {order}: error {:.1e}, orders {rates:.2?}", errors[2][order]);
            assert!(rates.iter().all(|rate| *rate > expected - 0.15), "{words} {order}: {rates:?}");
        }
    }
}

/// A last row that differs from the first by rounding is taken as equal, so that every turn is the same.
#[test]
fn periods_are_closed() {
    let law = |x: f64| 1e3 + x.sin();
    let table =
        table("linear, periodic", &sampled(even(0.0, std::f64::consts::TAU, 8), |x| law(x) * (1.0 + 1e-14 * x)));
    let end = table.knots[8];
    assert_eq!(table.derivative(0, end.next_down()), table.derivative(0, 0.0));
}

/// Value and slope are continuous at every row and at the ends, of a spline the second derivative between them as well.
#[test]
fn derivatives_are_continuous_as_said() {
    let mut rows = sampled(UNEVEN, |x| (3.0 * x).sin() + x);
    rows[6].1 = rows[0].1;
    for (words, inside, at_ends) in [
        ("cubic, continued", 2, 1),
        ("cubic, natural, continued", 2, 2),
        ("cubic, clamped, held", 2, 1),
        ("cubic, held", 2, 0),
        ("cubic, periodic", 2, 2),
        ("monotone, periodic", 1, 1),
        ("monotone, continued", 1, 1),
        ("linear, continued", 0, 1),
        ("linear, periodic", 0, 0),
        ("linear, held", 0, 0),
    ] {
        let table = table(words, &rows);
        for (i, x) in UNEVEN.iter().enumerate() {
            let is_end = i == 0 || i == 6;
            for order in 0..=if is_end { at_ends } else { inside } {
                let step = 1e-9;
                let jump = table.derivative(order, x + step) - table.derivative(order, x - step);
                // The next derivative is at most some thousands.
                assert!(jump.abs() < 1e-5, "{words}: derivative {order} at {x}: {jump:e}");
            }
        }
    }
}

/// A monotone table is never beyond the rows beside it.
#[test]
fn monotone_tables_do_not_overshoot() {
    let rows = [(0.0, 0.0), (0.1, 0.0), (1.0, 1.0), (1.2, 9.0), (3.0, 9.1), (3.5, 9.1), (3.6, -2.0), (5.0, -2.5)];
    let table = table("monotone, held", &rows);
    for pair in rows.windows(2) {
        let (low, high) = (pair[0].1.min(pair[1].1), pair[0].1.max(pair[1].1));
        for x in even(pair[0].0, pair[1].0, 50) {
            let y = table.derivative(0, x);
            assert!(y >= low - 1e-14 && y <= high + 1e-14, "{x}: {y}");
        }
    }
}

/// Whatever the words, kernels' formulas and the oracle's are the same function, from two rows to many, near and far.
#[test]
fn the_oracle_agrees() {
    let mut random = 1u64;
    let mut next = move || {
        random = random.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (random >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut worst = 0.0f64;
    for between in ["linear", "monotone", "cubic", "cubic, natural", "cubic, clamped"] {
        for outside in ["held", "continued", "periodic"] {
            if outside == "periodic" && between.contains(',') {
                continue;
            }
            for count in [2, 3, 4, 5, 9, 40] {
                let mut x = 3.0 * next() - 1.5;
                let mut rows = Vec::new();
                for _ in 0..count {
                    rows.push((x, 4.0 * next() - 2.0));
                    x += 0.05 + next();
                }
                if outside == "periodic" {
                    rows[count - 1].1 = rows[0].1;
                }
                let words = format!("{between}, {outside}");
                let table = table(&words, &rows);
                let declaration = codegen::parse(declaration(&words, &rows).parse().unwrap()).unwrap();
                let oracle = Oracle::new(&declaration, &|_| 1.0);
                for _ in 0..30 {
                    let (q, speed) = (rows[0].0 - 1.0 + (x - rows[0].0 + 2.0) * next(), 2.0 * next() - 1.0);
                    let at = State { time: 0.0, parameters: &[], inputs: &[], coordinates: &[q], speeds: &[speed] };
                    let terms = oracle.terms(&at).unwrap();
                    let outputs = oracle.outputs(&at, &oracle.accelerations(&terms).unwrap()).unwrap();
                    let [f0, f1, f2] = [0, 1, 2].map(|order| table.derivative(order, q));
                    for (found, expected) in [f0, f1 * speed, f2 * speed * speed].into_iter().zip(&outputs) {
                        let error = (found - expected.value).abs() / expected.magnitude;
                        assert!(error < 1e-13, "{words}, {count} rows at {q}: {found} {expected:?}");
                        worst = worst.max(error);
                    }
                }
            }
        }
    }
    println!("tables and oracle differ by {worst:.1e} of what goes into them");
}

const FRAGMENT: &str = "pub Followers; const n = 4;
    coordinates { a [rad]; x [m]; y [m]; }
    tables { tall [mm] over [deg] = cubic, periodic { 0, 0; 180, 30; 360, 0; } }
    fragment Follower(height, law) {
        tables {
            /// How hard it presses.
            press [N] over [mm] = linear { repeat i in 0..=n { 10*i, i^2; } };
        }
        bodies { tip: mass 1 [kg] at [0, height]; }
        constraints { lifted: height = 0.1 [m] + law(a); }
        loads { force [0, -press(height)] at [0, height]; }
    }
    use Follower(x, tall) as left; use Follower(y, tall) as right;
    bodies { cam: inertia 1 [kg*m^2], angle a; }";

/// A table of a fragment belongs to the instance; one of the mechanism can be an argument.
#[test]
fn fragments_have_tables() {
    let graph = codegen::equations(FRAGMENT.parse().unwrap()).unwrap().graph;
    let names: Vec<&str> = graph.tables().iter().map(|table| table.name.as_str()).collect();
    assert_eq!(names, ["tall", "left_press", "right_press"]);
    let spring = &graph.tables()[1];
    assert_eq!(
        (spring.knots[3], spring.derivative(0, 0.02), spring.docs.as_str()),
        (0.03, 4.0, "How hard it presses.")
    );
    let values = codegen::equations_as(codegen::notation::Notation::Infix, FRAGMENT).unwrap();
    let constraints = values.iter().find(|part| part.name == "constraints").unwrap();
    assert!(constraints.text.contains("tall(a)"), "{}", constraints.text);
}
