//! Rotations as matrices of jets.

use super::error::{Result, refuse};
use super::jet::Jet;
use super::measured::Measured;
use super::sizes::Sizes;
use crate::dsl::{Expression, Kind};

/// R, with the quaternions of coordinates in it.
#[derive(Clone, Debug)]
pub(super) struct Rotation {
    /// Nine entries, row by row.
    pub(super) entries: Vec<Jet>,
    pub(super) quaternions: Vec<[Jet; 4]>,
}

impl Rotation {
    /// I + sin(a) N + (1 - cos(a)) N^2, N being the matrix of n x: Rodrigues.
    pub(super) fn about(axis: &[Jet], angle: &Jet) -> Option<Rotation> {
        let (sine, cosine) = (angle.call("sin")?, angle.call("cos")?);
        let [zero, one] = [0.0, 1.0].map(|x| Jet::constant(Measured::given(x), angle.gradient().len()));
        let [x, y, z] = <[Jet; 3]>::try_from(axis.to_vec()).ok()?;
        let n = vec![zero.clone(), -&z, y.clone(), z, zero.clone(), -&x, -&y, x, zero.clone()];
        let versine = &one - &cosine;
        let square = product(&n, &n);
        let entry = |k: usize| {
            let turned = &(&sine * &n[k]) + &(&versine * &square[k]);
            if k.is_multiple_of(4) { &one + &turned } else { turned }
        };
        Some(Rotation { entries: (0..9).map(entry).collect(), quaternions: vec![] })
    }

    /// That of a quaternion's direction, u = q/|q|.
    pub(super) fn of_quaternion(q: [Jet; 4], is_of_coordinates: bool) -> Option<Rotation> {
        let square = q.iter().map(|x| x * x).reduce(|sum, x| &sum + &x)?;
        let norm = square.call("sqrt")?;
        let [a, b, c, d] = q.each_ref().map(|x| x / &norm);
        let twice = |x: Jet| &x + &x;
        let diagonal = |p: &Jet, m: &Jet, n: &Jet| &(&(&a * &a) + &(p * p)) - &(&(m * m) + &(n * n));
        let entries = vec![
            diagonal(&b, &c, &d),
            twice(&(&b * &c) - &(&a * &d)),
            twice(&(&b * &d) + &(&a * &c)),
            twice(&(&b * &c) + &(&a * &d)),
            diagonal(&c, &b, &d),
            twice(&(&c * &d) - &(&a * &b)),
            twice(&(&b * &d) - &(&a * &c)),
            twice(&(&c * &d) + &(&a * &b)),
            diagonal(&d, &b, &c),
        ];
        Some(Rotation { entries, quaternions: if is_of_coordinates { vec![q] } else { vec![] } })
    }

    /// R S.
    pub(super) fn then(&self, other: &Rotation) -> Rotation {
        let quaternions = self.quaternions.iter().chain(&other.quaternions).cloned().collect();
        let sizes = Sizes::of(&self.entries).times(&Sizes::of(&other.entries));
        let entries = product(&self.entries, &other.entries);
        Rotation { entries: sizes.bound(&entries), quaternions }
    }

    /// R'.
    pub(super) fn transposed(&self) -> Rotation {
        let entries = (0..9).map(|k| self.entries[3 * (k % 3) + k / 3].clone()).collect();
        Rotation { entries, quaternions: self.quaternions.clone() }
    }

    /// R v.
    pub(super) fn turn(&self, v: &[Jet]) -> Result<Vec<Jet>> {
        if v.len() != 3 {
            return refuse("a rotation turns vectors of three components");
        }
        let sizes = Sizes::of(&self.entries).times(&Sizes::of(v));
        let turned: Vec<Jet> = self.entries.chunks(3).map(|row| inner(row, v)).collect();
        Ok(sizes.bound(&turned))
    }

    /// vee of the skew part of R' R^T, given the rates of the entries.
    pub(super) fn angular_velocity(&self, rates: &[Jet]) -> Vec<Jet> {
        let swept = product(rates, &self.transposed().entries);
        let half = Jet::constant(Measured::given(0.5), swept[0].gradient().len());
        [(7, 5), (2, 6), (3, 1)].iter().map(|(plus, minus)| &half * &(&swept[*plus] - &swept[*minus])).collect()
    }
}

fn product(a: &[Jet], b: &[Jet]) -> Vec<Jet> {
    let column = |j: usize| [b[j].clone(), b[3 + j].clone(), b[6 + j].clone()];
    (0..9).map(|k| inner(&a[3 * (k / 3)..3 * (k / 3) + 3], &column(k % 3))).collect()
}

fn inner(a: &[Jet], b: &[Jet]) -> Jet {
    &(&(&a[0] * &b[0]) + &(&a[1] * &b[1])) + &(&a[2] * &b[2])
}

/// The letter of an axis, if an expression is that alone.
pub(super) fn letter(expression: &Expression) -> Option<usize> {
    match &expression.kind {
        Kind::Name(name) => ["x", "y", "z"].iter().position(|axis| name == axis),
        _ => None,
    }
}
