//! Rows by all of their entries.

use super::{Linear, Rows};
use crate::model::level::between_positions;
use crate::motion::measures::Measures;
use crate::numerics::arrays::inner;
use crate::numerics::factors::Undefined;
use crate::numerics::solve::Definite;
use sim_kernel::{Array, Mechanism};

/// Rows by all of their entries.
pub(crate) struct Dense;

impl<M: Mechanism> Rows<M> for Dense {
    type Jacobian = M::LQ;
    type Factors = Definite<M::LL, M::L>;

    #[inline(always)]
    fn linearization(mechanism: &M, time: f64, q: &M::Q) -> Linear<M, Dense> {
        mechanism.constraint_linearization(time, q)
    }

    #[inline(always)]
    fn columns(jacobian: &M::LQ, measures: &Measures<M>) -> M::LQ {
        measures.columns(jacobian)
    }

    #[inline(always)]
    fn between_positions(jacobian: &M::LQ) -> M::LQ {
        between_positions::<M>(jacobian)
    }

    #[inline(always)]
    fn times(jacobian: &M::LQ, x: &M::Q) -> M::L {
        M::L::from_fn(|i| inner(&jacobian[i], x))
    }

    #[inline(always)]
    fn terms(jacobian: &M::LQ, row: usize, x: &M::Q) -> f64 {
        jacobian[row].iter().zip(x.iter()).map(|(c, x)| (c * x).abs()).sum()
    }

    #[inline(always)]
    fn transposed_times(jacobian: &M::LQ, y: &M::L) -> M::Q {
        M::Q::from_fn(|j| (0..M::L::LEN).map(|i| jacobian[i][j] * y[i]).sum())
    }

    #[inline(always)]
    fn factorise(jacobian: &M::LQ, factors: &mut Definite<M::LL, M::L>) -> Result<(), Undefined> {
        let mut gram = M::LL::filled(M::L::filled(0.0));
        for i in 0..M::L::LEN {
            for j in 0..=i {
                gram[i][j] = inner(&jacobian[i], &jacobian[j]);
            }
        }
        *factors = Definite::new(gram)?;
        Ok(())
    }

    #[inline(always)]
    fn constraint(k: usize) -> usize {
        k
    }
}
