//! The values of a declaration's names.

use super::jet::Jet;
use super::measured::Measured;
use super::state::State;
use super::value::Value;

/// The values of a declaration's names.
pub(super) struct Setting {
    /// The number of variables of the jets.
    pub(super) variables: usize,
    /// The first of the declaration's parameters; later ones are not yet known.
    pub(super) parameters: Vec<Jet>,
    /// The coordinates and the time; `None` where only parameters are known.
    pub(super) motion: Option<(Vec<Jet>, Jet)>,
    /// The auxiliary displacements, where they are variables; elsewhere they are the number zero.
    pub(super) auxiliaries: Vec<Jet>,
    /// The meaning of `dot`.
    pub(super) rates: Rates,
    /// The value that each input is set to, where inputs are allowed.
    pub(super) inputs: Option<Vec<Option<f64>>>,
    /// The multipliers of each constraint and the forces conjugate to auxiliary displacements, where they are known.
    pub(super) reactions: Option<Vec<Value>>,
}

/// The meaning of `dot`.
pub(super) enum Rates {
    /// Nothing: there is no motion.
    None,
    /// The one variable is time along the motion.
    AlongTime,
    /// The variables change at these rates, of which those of coordinates are variables themselves.
    Of(Vec<Jet>),
}

impl Setting {
    /// Parameters alone.
    pub(super) fn fixed(parameters: &[f64]) -> Setting {
        let parameters = constants(parameters, 0);
        let (motion, auxiliaries, rates) = (None, vec![], Rates::None);
        Setting { variables: 0, parameters, motion, auxiliaries, rates, inputs: None, reactions: None }
    }

    /// Positions: jets in the variables (q, t, s), s being the auxiliary displacements.
    pub(super) fn positions(time: f64, parameters: &[f64], coordinates: &[f64], auxiliaries: usize) -> Setting {
        Setting::of_positions(time, parameters, coordinates, auxiliaries, coordinates.len() + 1 + auxiliaries)
    }

    /// Quantities between speeds: jets in the variables (q, t, s, q', s').
    pub(super) fn speeds(at: &State, auxiliaries: usize) -> Setting {
        let n = at.coordinates.len();
        let (first, variables) = (n + 1 + auxiliaries, 2 * n + 1 + 2 * auxiliaries);
        let rate = |value: f64, place: usize| Jet::variable(value, first + place, variables);
        let coordinates = at.speeds.iter().enumerate().map(|(i, speed)| rate(*speed, i));
        let time = Jet::constant(Measured::given(1.0), variables);
        let displacements = (0..auxiliaries).map(|k| rate(0.0, n + k));
        let rates = coordinates.chain([time]).chain(displacements).collect();
        let positions = Setting::of_positions(at.time, at.parameters, at.coordinates, auxiliaries, variables);
        Setting { rates: Rates::Of(rates), ..positions }
    }

    fn of_positions(
        time: f64,
        parameters: &[f64],
        coordinates: &[f64],
        auxiliaries: usize,
        variables: usize,
    ) -> Setting {
        let n = coordinates.len();
        let q = coordinates.iter().enumerate().map(|(i, q)| Jet::variable(*q, i, variables)).collect();
        Setting {
            variables,
            parameters: constants(parameters, variables),
            motion: Some((q, Jet::variable(time, n, variables))),
            auxiliaries: (0..auxiliaries).map(|k| Jet::variable(0.0, n + 1 + k, variables)).collect(),
            rates: Rates::None,
            inputs: None,
            reactions: None,
        }
    }

    /// Quantities along the motion: jets in time alone, of `coordinates` as functions of time.
    pub(super) fn motion(time: f64, parameters: &[f64], coordinates: Vec<Jet>) -> Setting {
        Setting {
            variables: 1,
            parameters: constants(parameters, 1),
            motion: Some((coordinates, Jet::variable(time, 0, 1))),
            auxiliaries: vec![],
            rates: Rates::AlongTime,
            inputs: None,
            reactions: None,
        }
    }

    /// The same with what each input is set to.
    pub(super) fn with_inputs(self, inputs: &[Option<f64>]) -> Setting {
        Setting { inputs: Some(inputs.to_vec()), ..self }
    }

    /// The same with the multipliers of each constraint, in order, and the forces conjugate to auxiliary displacements.
    pub(super) fn with_reactions(self, reactions: Vec<Value>) -> Setting {
        Setting { reactions: Some(reactions), ..self }
    }
}

impl State<'_> {
    /// Along the motion, as far as q and q' tell.
    pub(super) fn motion(&self) -> Setting {
        self.along(|_| None)
    }

    /// Along the motion with q'' known too.
    pub(super) fn accelerated_motion(&self, accelerations: &[Measured]) -> Setting {
        self.along(|i| accelerations.get(i).copied())
    }

    /// As if nothing moved: `dot` has no meaning.
    pub(super) fn still(&self) -> Setting {
        Setting {
            variables: 0,
            parameters: constants(self.parameters, 0),
            motion: Some((constants(self.coordinates, 0), Jet::constant(Measured::given(self.time), 0))),
            auxiliaries: vec![],
            rates: Rates::None,
            inputs: Some(self.inputs.to_vec()),
            reactions: None,
        }
    }

    fn along(&self, acceleration: impl Fn(usize) -> Option<Measured>) -> Setting {
        let coordinate = |(i, (q, speed)): (usize, (&f64, &f64))| {
            let derivatives: Vec<Measured> =
                [Some(Measured::given(*speed)), acceleration(i)].into_iter().flatten().collect();
            Jet::of_time(Measured::given(*q), &derivatives)
        };
        let coordinates = self.coordinates.iter().zip(self.speeds).enumerate().map(coordinate).collect();
        Setting::motion(self.time, self.parameters, coordinates).with_inputs(self.inputs)
    }
}

fn constants(values: &[f64], variables: usize) -> Vec<Jet> {
    values.iter().map(|value| Jet::constant(Measured::given(*value), variables)).collect()
}
