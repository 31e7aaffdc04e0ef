//! The equations of motion: terms at a state, and the accelerations and multipliers that solve them.
//!
//! ```text
//! [ M    C_q' ] [ q''    ]   [ generalized_forces    ]     M = T_q' diag(m) T_q
//! [ C_q  0    ] [ lambda ] = [ -constraint_convective ]
//! ```

use super::error::Result;
use super::jet::Jet;
use super::measured::{Measured, inner};
use super::mechanics::Mechanics;
use super::solve::Factors;

/// The terms of the equations of motion at one state: n coordinates, c rows of constraints.
///
/// A constraint between vectors has two rows, x and y. Everything is in SI units.
#[derive(Clone, Debug)]
pub struct Terms {
    /// M = T_q' diag(m) T_q \[n by n\].
    pub mass_matrix: Vec<Vec<Measured>>,
    /// T_q' F \[n\]: loads and gravity.
    pub applied_forces: Vec<Measured>,
    /// T_q' diag(m) g \[n\], where g = (T_q q' + T_t)_q q' + (T_q q' + T_t)_t.
    pub convective: Vec<Measured>,
    /// `applied_forces` - `convective` \[n\]: the whole of the right-hand side.
    pub generalized_forces: Vec<Measured>,
    /// C = left - right \[c\]; zero for rows between speeds.
    pub constraints: Vec<Measured>,
    /// C_q \[c by n\]; for a row w = 0 between speeds w_q', and below w less w_q' q', and w' without accelerations.
    pub constraint_jacobian: Vec<Vec<Measured>>,
    /// C_t \[c\].
    pub constraint_time_derivative: Vec<Measured>,
    /// (C_q q' + C_t)_q q' + (C_q q' + C_t)_t \[c\], with its own sign: C'' = C_q q'' + this.
    pub constraint_convective: Vec<Measured>,
    /// The sum of m v.v/2 + J w^2/2, J.
    pub kinetic_energy: Measured,
    /// Whether each row of the constraints holds.
    active: Vec<bool>,
}

/// The solution of the equations of motion.
///
/// Magnitudes are |A^-1| (|A| |x| + |b|) with the magnitudes of the terms in A and b: the effect of relative errors of
/// the terms on the solution.
#[derive(Clone, Debug)]
pub struct Solution {
    /// q'' \[n\].
    pub accelerations: Vec<Measured>,
    /// lambda \[c\]: the reaction does virtual work -lambda delta C on the system.
    pub multipliers: Vec<Measured>,
}

impl Terms {
    /// Rows that do not hold are zero.
    pub(super) fn new(mechanics: &Mechanics) -> Terms {
        let (n, rates) = (mechanics.coordinates, &mechanics.rates);
        let applied_forces = along(n, mechanics.efforts.iter().map(|effort| (effort.force, &effort.place)));
        let resisting = mechanics.rows.iter().map(|row| (row.inertia * row.partner.curvature(rates), &row.place));
        let convective = along(n, resisting);
        let constraints = mechanics.constraint_rows();
        Terms {
            mass_matrix: mass_matrix(mechanics, n),
            generalized_forces: applied_forces.iter().zip(&convective).map(|(a, b)| *a - *b).collect(),
            applied_forces,
            convective,
            constraints: constraints.iter().map(|row| row.value).collect(),
            constraint_jacobian: constraints.iter().map(|row| row.jacobian.clone()).collect(),
            constraint_time_derivative: constraints.iter().map(|row| row.time_derivative).collect(),
            constraint_convective: constraints.iter().map(|row| row.convective).collect(),
            kinetic_energy: kinetic_energy(mechanics, rates),
            active: constraints.iter().map(|row| row.active).collect(),
        }
    }

    pub(super) fn solve(&self) -> Result<Solution> {
        let (matrix, right) = (self.matrix(), self.right_hand_side());
        let values = |row: &[Measured]| -> Vec<f64> { row.iter().map(|entry| entry.value).collect() };
        let factors = Factors::new(matrix.iter().map(|row| values(row)).collect())?;
        let solution = factors.solve(&values(&right));
        let given: Vec<Measured> = solution.iter().map(|x| Measured::given(*x)).collect();
        let entered = matrix.iter().zip(&right).map(|(row, b)| inner(row, &given).magnitude + b.magnitude);
        let magnitudes = factors.amplify(&entered.collect::<Vec<_>>());
        let mut measured =
            solution.iter().zip(magnitudes).map(|(value, magnitude)| Measured { value: *value, magnitude });
        let accelerations = measured.by_ref().take(self.mass_matrix.len()).collect();
        let multiplier = |active: &bool| if *active { measured.next().unwrap_or_default() } else { Measured::ZERO };
        Ok(Solution { accelerations, multipliers: self.active.iter().map(multiplier).collect() })
    }

    /// [M, C_q'; C_q, 0] with the rows that hold.
    fn matrix(&self) -> Vec<Vec<Measured>> {
        let jacobian: Vec<&Vec<Measured>> = self.held(&self.constraint_jacobian).collect();
        let c = jacobian.len();
        let upper = self.mass_matrix.iter().enumerate();
        let upper = upper.map(|(j, row)| row.iter().copied().chain(jacobian.iter().map(|row| row[j])).collect());
        let lower = jacobian.iter().map(|row| row.iter().copied().chain(vec![Measured::ZERO; c]).collect());
        upper.chain(lower).collect()
    }

    /// The entries of rows that hold.
    fn held<'t, T>(&'t self, rows: &'t [T]) -> impl Iterator<Item = &'t T> {
        rows.iter().zip(&self.active).filter(|(_, active)| **active).map(|(row, _)| row)
    }

    fn right_hand_side(&self) -> Vec<Measured> {
        let lower = self.held(&self.constraint_convective).map(|convective| -*convective);
        self.generalized_forces.iter().copied().chain(lower).collect()
    }
}

/// The sum of force times place_q \[n\].
fn along<'m>(n: usize, forces: impl Iterator<Item = (Measured, &'m Jet)>) -> Vec<Measured> {
    let mut sum = vec![Measured::ZERO; n];
    for (force, place) in forces {
        sum.iter_mut().zip(place.gradient()).for_each(|(sum, slope)| *sum = *sum + force * *slope);
    }
    sum
}

fn mass_matrix(mechanics: &Mechanics, n: usize) -> Vec<Vec<Measured>> {
    let column = |i: usize| mechanics.rows.iter().map(move |row| (row.inertia * row.partner.gradient()[i], &row.place));
    (0..n).map(|i| along(n, column(i))).collect()
}

fn kinetic_energy(mechanics: &Mechanics, rates: &[Measured]) -> Measured {
    let twice = mechanics.rows.iter().map(|row| row.inertia * row.place.slope(rates) * row.partner.slope(rates));
    Measured::given(0.5) * twice.sum()
}
