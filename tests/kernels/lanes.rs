//! Many states at once give what one state after the other gives, bit by bit, with all vector instructions that this
//! processor has.

use crate::all::all_mechanisms;
use crate::oracle::OVERCONSTRAINED;
use sim::{Array, Compiled, Dynamics, FixedArray, Lanes, Scalar, State, Vectors, accelerate, accelerate_each_with};
use tests::Random;

/// Not a multiple of the number of lanes.
const STATES: usize = 1003;

fn all_vectors() -> Vec<Vectors> {
    [Some(Vectors::BASELINE), Vectors::avx2(), Vectors::avx512()].into_iter().flatten().collect()
}

#[test]
fn every_mechanism_has_the_same_bits_in_lanes() {
    macro_rules! check_all {
        ($($model:ty),*) => { $(check::<$model>();)* };
    }
    // Without optimisation the vectors of a long kernel take more than the stack of a test.
    let checks = || {
        all_mechanisms!(check_all);
    };
    std::thread::Builder::new().stack_size(1 << 28).spawn(checks).unwrap().join().unwrap();
}

fn check<M: Compiled>() {
    let mut random = Random(5);
    let mechanism = M::defaults();
    let mut states: Vec<State<M>> = (0..STATES)
        .map(|_| State {
            time: random.between(0.0, 2.0),
            positions: M::Q::from_fn(|_| random.between(-1.5, 1.5)),
            speeds: M::Q::from_fn(|_| random.between(-3.0, 3.0)),
            work: 0.0,
        })
        .collect();
    // One fails, and an angle beyond the range of the vector routine takes another way.
    states[500].positions = M::Q::filled(f64::NAN);
    states[501].positions = M::Q::filled(1e9);
    for vectors in all_vectors() {
        let mut found = Vec::new();
        let failures = accelerate_each_with(vectors, &mechanism, &states, &mut found);
        let mut expected_failures = Vec::new();
        for (i, (state, found)) in states.iter().zip(&found).enumerate() {
            match accelerate(&mechanism, state.time, &state.positions, &state.speeds) {
                Ok(expected) => assert_eq!(bits::<M>(found), bits::<M>(&expected), "{} {i}", M::DESCRIPTION.name),
                Err(failure) => expected_failures.push((i, failure)),
            }
        }
        assert_eq!(found.len(), STATES);
        // The equations of a body that falls freely know of no position.
        assert_eq!(found[500].refused, expected_failures.iter().any(|(i, _)| *i == 500), "{}", M::DESCRIPTION.name);
        let is_solved = expected_failures.len() < STATES / 20 || M::DESCRIPTION.name == OVERCONSTRAINED;
        assert!(is_solved, "{}", expected_failures.len());
        // As text, because a NaN in a failure's state is not equal to itself.
        assert_eq!(format!("{failures:?}"), format!("{expected_failures:?}"));
    }
}

fn bits<M: Compiled>(solved: &Dynamics<f64, M::Q, M::L>) -> (Vec<u64>, bool) {
    let values = solved.accelerations.iter().chain(solved.multipliers.iter()).chain([&solved.power]);
    (values.map(|value| value.to_bits()).collect(), solved.refused)
}

#[test]
fn no_states_and_fewer_than_there_are_lanes() {
    let mechanism = models::QuickReturn::default();
    let state = State { time: 0.0, positions: [0.1, 1.0, 2.6], speeds: [1.0, 0.2, 0.3], work: 0.0 };
    let mut found = Vec::new();
    for count in [3, 0, 1] {
        assert!(sim::accelerate_each(&mechanism, &vec![state.clone(); count], &mut found).is_empty());
        assert_eq!(found.len(), count);
    }
}

/// Each lane is the scalar, in every function, also where it is NaN, infinite or zero with a sign.
#[test]
fn every_function_is_the_scalar_function_in_every_lane() {
    let special = [0.0, -0.0, 1.0, -2.5, f64::INFINITY, f64::NEG_INFINITY, f64::NAN, 1e7];
    let mut random = Random(6);
    for _ in 0..200 {
        let ordinary = Lanes::<8>::from_fn(|_| random.between(-4.0, 4.0));
        compare(ordinary, Lanes::from_fn(|lane| special[lane]));
        compare(Lanes::from_fn(|lane| special[lane]), ordinary);
        compare(ordinary, Lanes::from_fn(|_| random.between(-4.0, 4.0)));
    }
}

fn compare(a: Lanes<8>, b: Lanes<8>) {
    fn all<S: Scalar>(a: S, b: S) -> Vec<S> {
        let ([sine, other_sine], [cosine, other_cosine]) = S::sin_cos_each([a, b]);
        let chosen = S::select(a.greater(b), a, S::select(S::not(b.greater(a)), b, -a));
        let operations =
            [a + b, a - b, a * b, a / b, -a, sine, cosine, other_sine, other_cosine, a.sin(), a.cos(), chosen];
        let functions =
            [a.tan(), a.asin(), a.acos(), a.atan(), a.sinh(), a.cosh(), a.tanh(), a.exp(), a.ln(), a.sqrt()];
        [operations.to_vec(), functions.to_vec(), vec![a.abs(), a.sign(), a.atan2(b), a.powf(b)]].concat()
    }
    let in_lanes = all(a, b);
    for lane in 0..8 {
        for (i, (found, expected)) in in_lanes.iter().zip(all(a.lane(lane), b.lane(lane))).enumerate() {
            let found = found.lane(lane);
            // Which NaN an operation gives is not defined.
            let same = found.to_bits() == expected.to_bits() || (found.is_nan() && expected.is_nan());
            assert!(same, "function {i} of {} and {}: {found} {expected}", a.lane(lane), b.lane(lane));
        }
    }
}
