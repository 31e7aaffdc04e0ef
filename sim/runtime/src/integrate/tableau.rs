//! Butcher tableaus, as data.

/// A stage and its weight; stages that are not listed have weight 0.
pub type Weight = (usize, f64);

/// An explicit Runge-Kutta method: stage i is evaluated at t + c_i h with the state advanced by h sum of a_ij k_j, and
/// the step advances by h sum of b_i k_i.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tableau {
    /// For each stage the weights of earlier ones.
    pub a: &'static [&'static [Weight]],
    /// Weights of the step.
    pub b: &'static [Weight],
    /// Nodes.
    pub c: &'static [f64],
    /// Order of convergence.
    pub order: usize,
    /// The error estimate.
    pub error: ErrorEstimate,
    /// Weights of the stages in the term s^2 (1 - s)^2 of the dense output, whose other terms follow from both ends; its
    /// last stage is the end. Without any, the ends alone give it.
    pub dense: &'static [Weight],
}

impl Tableau {
    /// The number of stages that the step itself uses.
    #[inline]
    pub(super) const fn stages_of_step(&self) -> usize {
        let (mut stages, mut i) = (0, 0);
        while i < self.b.len() {
            stages = if self.b[i].0 >= stages { self.b[i].0 + 1 } else { stages };
            i += 1;
        }
        stages
    }

    /// The stage at the end of the step before that of its error, and how large h |lambda| may be; of methods that choose their steps.
    /// From the programs `dop853.f` and `dopri5.f` of Hairer and Wanner.
    pub(super) fn stability(&self) -> Option<(usize, f64)> {
        match self.error {
            ErrorEstimate::None => None,
            ErrorEstimate::Embedded(_) => (self.order == 5).then_some((5, 3.25)),
            ErrorEstimate::Embedded53(..) => (self.order == 8).then_some((11, 6.1)),
        }
    }

    /// The middle of the widest gap between nodes, the last of several.
    pub(super) fn gap(&self) -> f64 {
        let mut widest = (0.0, 0.5);
        for begin in self.c {
            let end = self.c.iter().copied().filter(|end| end > begin).fold(1.0, f64::min);
            if end - begin >= widest.0 {
                widest = (end - begin, (begin + end) / 2.0);
            }
        }
        widest.1
    }
}

/// The error estimate of a step, from weights of its stages.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ErrorEstimate {
    /// Not at all.
    None,
    /// By the difference from a method of the order below.
    Embedded(&'static [Weight]),
    /// By |e5|^2 / sqrt(|e5|^2 + |e3|^2/100), from differences to methods of order 5 and 3.
    Embedded53(&'static [Weight], &'static [Weight]),
}

/// The number of stages of the largest method, including its dense output.
pub(crate) const MOST_STAGES: usize = 16;

/// Euler's explicit method.
pub const EULER: Tableau =
    Tableau { a: &[&[]], b: &[(0, 1.0)], c: &[0.0], order: 1, error: ErrorEstimate::None, dense: &[] };

/// Heun's method of order 2: the trapezoidal rule with Euler's prediction.
pub const HEUN: Tableau = Tableau {
    a: &[&[], &[(0, 1.0)]],
    b: &[(0, 0.5), (1, 0.5)],
    c: &[0.0, 1.0],
    order: 2,
    error: ErrorEstimate::None,
    dense: &[],
};

/// Kutta's method of order 3 (1901).
pub const RK3: Tableau = Tableau {
    a: &[&[], &[(0, 0.5)], &[(0, -1.0), (1, 2.0)]],
    b: &[(0, 1.0 / 6.0), (1, 2.0 / 3.0), (2, 1.0 / 6.0)],
    c: &[0.0, 0.5, 1.0],
    order: 3,
    error: ErrorEstimate::None,
    dense: &[],
};

/// The classical method of Runge and Kutta (Kutta 1901).
pub const RK4: Tableau = Tableau {
    a: &[&[], &[(0, 0.5)], &[(1, 0.5)], &[(2, 1.0)]],
    b: &[(0, 1.0 / 6.0), (1, 1.0 / 3.0), (2, 1.0 / 3.0), (3, 1.0 / 6.0)],
    c: &[0.0, 0.5, 0.5, 1.0],
    order: 4,
    error: ErrorEstimate::None,
    dense: &[],
};

/// Dormand and Prince 5(4) (Journal of Computational and Applied Mathematics 6, 1980). The last stage is at the end of
/// the step, before its projection, and serves the estimate alone.
pub const DOPRI5: Tableau = Tableau {
    a: &[
        &[],
        &[(0, 1.0 / 5.0)],
        &[(0, 3.0 / 40.0), (1, 9.0 / 40.0)],
        &[(0, 44.0 / 45.0), (1, -56.0 / 15.0), (2, 32.0 / 9.0)],
        &[(0, 19372.0 / 6561.0), (1, -25360.0 / 2187.0), (2, 64448.0 / 6561.0), (3, -212.0 / 729.0)],
        &[(0, 9017.0 / 3168.0), (1, -355.0 / 33.0), (2, 46732.0 / 5247.0), (3, 49.0 / 176.0), (4, -5103.0 / 18656.0)],
        DOPRI5_B,
    ],
    b: DOPRI5_B,
    c: &[0.0, 1.0 / 5.0, 3.0 / 10.0, 4.0 / 5.0, 8.0 / 9.0, 1.0, 1.0],
    order: 5,
    error: ErrorEstimate::Embedded(&[
        (0, 71.0 / 57600.0),
        (2, -71.0 / 16695.0),
        (3, 71.0 / 1920.0),
        (4, -17253.0 / 339200.0),
        (5, 22.0 / 525.0),
        (6, -1.0 / 40.0),
    ]),
    dense: DOPRI5_DENSE,
};

const DOPRI5_B: &[Weight] =
    &[(0, 35.0 / 384.0), (2, 500.0 / 1113.0), (3, 125.0 / 192.0), (4, -2187.0 / 6784.0), (5, 11.0 / 84.0)];

/// Of order 4, by Shampine (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, II.6, and their program
/// `dopri5.f`).
const DOPRI5_DENSE: &[Weight] = &[
    (0, -12_715_105_075.0 / 11_282_082_432.0),
    (2, 87_487_479_700.0 / 32_700_410_799.0),
    (3, -10_690_763_975.0 / 1_880_347_072.0),
    (4, 701_980_252_875.0 / 199_316_789_632.0),
    (5, -1_453_857_185.0 / 822_651_844.0),
    (6, 69_997_945.0 / 29_380_423.0),
];
