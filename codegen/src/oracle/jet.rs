//! Second-order forward differentiation: a value with its gradient and Hessian in k variables.
//!
//! In the n+1 variables (q, t) a jet is a position with all derivatives that its velocity and acceleration need. In one
//! variable, time along a motion, it is a quantity with its first and second time derivative.

use super::function::{self, Derivatives};
use super::measured::{Measured, inner};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A value, its gradient \[k\] and its symmetric Hessian \[k*k, row by row\].
///
/// Entries beyond `order` are never read: where only q and q' are known, second derivatives in time are not.
#[derive(Clone, Debug)]
pub(super) struct Jet {
    value: Measured,
    gradient: Vec<Measured>,
    hessian: Vec<Measured>,
    /// How many derivatives are known; [`CONSTANT`] if all are, because they are zero.
    order: u32,
}

const CONSTANT: u32 = u32::MAX;

impl Jet {
    /// A number that depends on no variable.
    pub(super) fn constant(value: Measured, variables: usize) -> Jet {
        let zeros = |length| vec![Measured::ZERO; length];
        Jet { value, gradient: zeros(variables), hessian: zeros(variables * variables), order: CONSTANT }
    }

    /// Itself, with magnitudes of at most these: of the value, of each derivative, of each second derivative.
    pub(super) fn bounded(&self, value: f64, gradient: &[f64], hessian: &[f64]) -> Jet {
        let bounded = |x: &Measured, bound: &f64| Measured { magnitude: x.magnitude.min(*bound), ..*x };
        let each =
            |entries: &[Measured], bounds: &[f64]| entries.iter().zip(bounds).map(|(x, b)| bounded(x, b)).collect();
        Jet {
            value: bounded(&self.value, &value),
            gradient: each(&self.gradient, gradient),
            hessian: each(&self.hessian, hessian),
            order: self.order,
        }
    }

    /// Variable number `index` of `variables`.
    pub(super) fn variable(value: f64, index: usize, variables: usize) -> Jet {
        let mut jet = Jet::constant(Measured::given(value), variables);
        jet.gradient[index] = Measured::given(1.0);
        jet.order = 2;
        jet
    }

    /// A function of time with as many known time derivatives as `derivatives` has entries beyond the value.
    pub(super) fn of_time(value: Measured, derivatives: &[Measured]) -> Jet {
        let mut jet = Jet::constant(value, 1);
        jet.gradient[0] = derivatives.first().copied().unwrap_or_default();
        jet.hessian[0] = derivatives.get(1).copied().unwrap_or_default();
        jet.order = derivatives.len().min(2) as u32;
        jet
    }

    pub(super) fn value(&self) -> Measured {
        self.value
    }

    pub(super) fn gradient(&self) -> &[Measured] {
        &self.gradient
    }

    pub(super) fn hessian(&self) -> &[Measured] {
        &self.hessian
    }

    /// Entry (i, j) of the Hessian.
    #[cfg(test)]
    pub(super) fn second(&self, i: usize, j: usize) -> Measured {
        self.hessian[i * self.variables() + j]
    }

    /// The first derivative along `direction` \[k\].
    pub(super) fn slope(&self, direction: &[Measured]) -> Measured {
        inner(&self.gradient, direction)
    }

    /// The second derivative along `direction` \[k\]: the quadratic form of the Hessian.
    pub(super) fn curvature(&self, direction: &[Measured]) -> Measured {
        let rows = self.hessian.chunks_exact(self.variables().max(1));
        rows.zip(direction).map(|(row, d)| *d * inner(row, direction)).sum()
    }

    /// The derivative by time, which is the first variable; `None` if it is not known.
    pub(super) fn dot(&self) -> Option<Jet> {
        let variables = self.variables();
        if self.is_constant() {
            return Some(Jet::constant(Measured::ZERO, variables));
        }
        let order = self.order.checked_sub(1)?;
        let (value, gradient) = (*self.gradient.first()?, self.hessian[..variables].to_vec());
        Some(Jet { gradient, order, ..Jet::constant(value, variables) })
    }

    /// The derivative along variables that change at given `rates`, themselves jets; `None` if it is not known.
    ///
    /// Of the result, a jet itself, only the gradient is known: u_i r_i has the derivatives u_ik r_i + u_i r_ik.
    pub(super) fn rate(&self, rates: &[Jet]) -> Option<Jet> {
        let variables = self.variables();
        match self.order {
            CONSTANT => Some(Jet::constant(Measured::ZERO, variables)),
            2 => {
                let mut rate = Jet::constant(self.slope(&rates.iter().map(Jet::value).collect::<Vec<_>>()), variables);
                rate.order = 1;
                for (i, (u_i, r)) in self.gradient.iter().zip(rates).enumerate() {
                    for k in 0..variables {
                        let change = self.hessian[i * variables + k] * r.value + *u_i * r.gradient[k];
                        rate.gradient[k] = rate.gradient[k] + change;
                    }
                }
                Some(rate)
            }
            _ => None,
        }
    }

    /// f(self), from f and its derivatives at this jet's value:
    /// gradient f' u_i, Hessian f' u_ij + f'' u_i u_j.
    pub(super) fn compose(&self, derivatives: Derivatives) -> Jet {
        self.compose_of_size(derivatives, [0.0; 3])
    }

    /// The same, where f, f' and f'' have these magnitudes.
    pub(super) fn compose_of_size(&self, [f, f1, f2, f3]: Derivatives, sizes: [f64; 3]) -> Jet {
        let of_size = |measured: Measured, size: f64| Measured { magnitude: measured.magnitude + size, ..measured };
        let value = of_size(Measured::function(f, f1, self.value), sizes[0]);
        if self.is_constant() {
            return Jet::constant(value, self.variables());
        }
        let first = of_size(Measured::function(f1, f2, self.value), sizes[1]);
        let second = of_size(Measured::function(f2, f3, self.value), sizes[2]);
        Jet {
            value,
            gradient: self.gradient.iter().map(|u_i| first * *u_i).collect(),
            hessian: self.hessian_by(|i, j, u_ij| first * u_ij + second * self.gradient[i] * self.gradient[j]),
            order: self.order,
        }
    }

    /// A function of the language by its name; `None` if there is none of that name.
    pub(super) fn call(&self, name: &str) -> Option<Jet> {
        function::elementary(name, self.value.value).map(|derivatives| self.compose(derivatives))
    }

    /// The angle of the vector (x, self): its derivatives are those of atan(y/x), or of -atan(x/y) where |x| < |y|.
    pub(super) fn atan2(&self, x: &Jet) -> Jet {
        let (y_value, x_value) = (self.value.value, x.value.value);
        let tangent = if x_value.abs() >= y_value.abs() { self / x } else { -&(x / self) };
        let mut angle = tangent.compose(function::arctangent(tangent.value.value));
        let turned = y_value.atan2(x_value);
        angle.value = Measured { value: turned, magnitude: turned.abs() + angle.value.magnitude };
        angle
    }

    /// self^exponent; for an exponent that varies exp(exponent ln self), which is NaN for self < 0.
    pub(super) fn power(&self, exponent: &Jet) -> Jet {
        if exponent.is_constant() {
            return self.compose(function::power(self.value.value, exponent.value.value));
        }
        let product = exponent * &self.compose(function::logarithm(self.value.value));
        product.compose(function::exponential(product.value.value))
    }

    /// (u v)_i = u_i v + u v_i and (u v)_ij = u_ij v + u_i v_j + u_j v_i + u v_ij.
    fn product(&self, other: &Jet) -> Jet {
        let (u, v) = (&self.gradient, &other.gradient);
        let k = self.variables();
        let second = |i: usize, j: usize, u_ij: Measured| {
            u_ij * other.value + u[i] * v[j] + u[j] * v[i] + self.value * other.hessian[i * k + j]
        };
        Jet {
            value: self.value * other.value,
            gradient: u.iter().zip(v).map(|(u_i, v_i)| *u_i * other.value + self.value * *v_i).collect(),
            hessian: self.hessian_by(second),
            order: self.order.min(other.order),
        }
    }

    fn is_constant(&self) -> bool {
        self.order == CONSTANT
    }

    fn variables(&self) -> usize {
        self.gradient.len()
    }

    /// The Hessian with entry (i, j), now u_ij, replaced by what `entry(i, j, u_ij)` gives.
    fn hessian_by(&self, entry: impl Fn(usize, usize, Measured) -> Measured) -> Vec<Measured> {
        let k = self.variables();
        self.hessian.iter().enumerate().map(|(at, u_ij)| entry(at / k, at % k, *u_ij)).collect()
    }

    /// Entry by entry, for what is linear in both.
    fn pairwise(&self, other: &Jet, combine: impl Fn(Measured, Measured) -> Measured) -> Jet {
        let each = |a: &[Measured], b: &[Measured]| a.iter().zip(b).map(|(a, b)| combine(*a, *b)).collect();
        Jet {
            value: combine(self.value, other.value),
            gradient: each(&self.gradient, &other.gradient),
            hessian: each(&self.hessian, &other.hessian),
            order: self.order.min(other.order),
        }
    }
}

impl Add for &Jet {
    type Output = Jet;
    fn add(self, other: &Jet) -> Jet {
        self.pairwise(other, |a, b| a + b)
    }
}

impl Sub for &Jet {
    type Output = Jet;
    fn sub(self, other: &Jet) -> Jet {
        self.pairwise(other, |a, b| a - b)
    }
}

impl Neg for &Jet {
    type Output = Jet;
    fn neg(self) -> Jet {
        self.pairwise(self, |a, _| -a)
    }
}

impl Mul for &Jet {
    type Output = Jet;
    fn mul(self, other: &Jet) -> Jet {
        self.product(other)
    }
}

impl Div for &Jet {
    type Output = Jet;
    fn div(self, other: &Jet) -> Jet {
        self.product(&other.compose(function::reciprocal(other.value.value)))
    }
}

#[cfg(test)]
mod tests;
