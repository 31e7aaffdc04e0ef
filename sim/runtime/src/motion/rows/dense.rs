//! Rows by all of their entries.

use super::{Linear, Rows, select_rows};
use crate::model::level::between_positions;
use crate::motion::measures::Measures;
use crate::numerics::arrays::inner;
use crate::numerics::numbers::sum;
use crate::numerics::solve::{Definite, Undefined};
use sim_kernel::{Array, Mechanism, Scalar};

/// Rows by all of their entries.
pub(crate) struct Dense;

impl<S: Scalar, M: Mechanism<S>> Rows<S, M> for Dense {
    type Jacobian = M::LQ;
    type Factors = Definite<M::LL, M::L, S>;

    #[inline(always)]
    fn linearization(mechanism: &M, time: S, q: &M::Q) -> Linear<S, M, Dense> {
        mechanism.constraint_linearization(time, q)
    }

    #[inline(always)]
    fn columns(mechanism: &M, jacobian: &M::LQ, measures: &Measures<M, S>) -> M::LQ {
        measures.columns(mechanism, jacobian)
    }

    #[inline(always)]
    fn between_positions(mechanism: &M, jacobian: &M::LQ) -> M::LQ {
        between_positions(mechanism, jacobian)
    }

    #[inline(always)]
    fn times(mechanism: &M, jacobian: &M::LQ, x: &M::Q) -> M::L {
        M::L::with_len(mechanism.m(), |i| inner(&jacobian[i], x))
    }

    #[inline(always)]
    fn terms(_mechanism: &M, jacobian: &M::LQ, row: usize, x: &M::Q) -> S {
        sum(jacobian[row].iter().zip(x.iter()).map(|(c, x)| (*c * *x).abs()))
    }

    #[inline(always)]
    fn transposed_times(mechanism: &M, jacobian: &M::LQ, y: &M::L) -> M::Q {
        M::Q::with_len(mechanism.n(), |j| sum((0..mechanism.m()).map(|i| jacobian[i][j] * y[i])))
    }

    #[inline(always)]
    fn factorise(_mechanism: &M, jacobian: &M::LQ, factors: &mut Definite<M::LL, M::L, S>) -> Result<(), Undefined> {
        factors.factorise(|i, j| inner(&jacobian[i], &jacobian[j]))
    }

    #[inline(always)]
    fn no_factors(mechanism: &M) -> Definite<M::LL, M::L, S> {
        Definite::blank(mechanism.m())
    }

    #[inline]
    fn pivot(_mechanism: &M, factors: &Definite<M::LL, M::L, S>, k: usize) -> (S, S) {
        factors.row(k)
    }

    #[inline]
    fn solve(_mechanism: &M, factors: &Definite<M::LL, M::L, S>, rhs: M::L) -> M::L {
        factors.solve(rhs)
    }

    #[inline(always)]
    fn constraint(_mechanism: &M, k: usize) -> usize {
        k
    }

    #[inline]
    fn select(mask: S::Mask, yes: M::LQ, no: &M::LQ) -> M::LQ {
        select_rows(mask, &yes, no)
    }

    #[inline]
    fn select_factors(
        mask: S::Mask,
        yes: Definite<M::LL, M::L, S>,
        no: &Definite<M::LL, M::L, S>,
    ) -> Definite<M::LL, M::L, S> {
        yes.or(mask, no)
    }
}
