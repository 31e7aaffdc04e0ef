//! Real matrices whose eigenvalues are known exactly, and how far computed ones are off.
//!
//! Each is a Jordan form of integers under a similarity by integers whose inverse is of integers too, and then scaled by powers of two:
//! rows against columns, and as a whole. All of that is exact in 64-bit floating point.

use crate::Random;
use nalgebra::{Complex, DMatrix, DVector};
use sim::{Eigen, eigen};

/// How far an eigenvalue may be off, as a part of the norm of the balanced matrix times that of the spectral projector,
/// which is 1/|y'x| for a simple one. Some 60 roundings of 60 entries are 1e-12.
const PART: f64 = 1e-10;
/// Eigenvalues that a perturbation of this part of the norm may bring together are one cluster: a defective one of order k moves by its
/// k-th root.
const PERTURBATION: f64 = 1e-12;

/// A matrix and its eigenvalues.
pub struct Exact {
    /// It.
    pub matrix: DMatrix<f64>,
    /// Its eigenvalues.
    clusters: Vec<Cluster>,
    /// The norm of the balanced matrix, which is the matrix with row i divided and column i multiplied by these.
    norm: f64,
    scales: Vec<f64>,
}

/// An eigenvalue, or several that are not told apart, with the norm of the projector onto their invariant subspace.
struct Cluster {
    values: Vec<Complex<f64>>,
    /// A basis of the subspace, n x k, and the rows of the inverse that belong to it, k x n; of the balanced matrix.
    right: DMatrix<Complex<f64>>,
    left: DMatrix<Complex<f64>>,
    /// The size of the largest Jordan block.
    order: usize,
    /// How far its eigenvalues may go.
    reach: f64,
}

/// A Jordan block of a + i b and, unless b is 0, of its conjugate.
struct Block {
    a: i64,
    b: i64,
    order: usize,
}

impl Block {
    fn draw(random: &mut Random, most: usize) -> Block {
        let within = |random: &mut Random, most: usize| below(random, 2 * most + 1) as i64 - most as i64;
        let order = if below(random, 3) == 0 { 1 + below(random, 4) } else { 1 };
        match below(random, 4) {
            0 => Block { a: 0, b: 0, order: order.min(most) },
            1 if most >= 2 => {
                Block { a: within(random, 20), b: 1 + below(random, 20) as i64, order: order.min(2).min(most / 2) }
            }
            _ => Block { a: within(random, 20), b: 0, order: order.min(most) },
        }
    }

    /// 2 for a pair.
    fn width(&self) -> usize {
        if self.b == 0 { 1 } else { 2 }
    }

    fn rows(&self) -> usize {
        self.width() * self.order
    }
}

/// A matrix of integers under elementary similarities: A = P J P^-1.
struct Similar {
    a: DMatrix<i64>,
    p: DMatrix<i64>,
    inverse: DMatrix<i64>,
}

/// Entries grow no larger than this, so that they and their sums are exact.
const LARGEST: i64 = 1 << 40;

impl Similar {
    fn new(blocks: &[Block]) -> Similar {
        let n = blocks.iter().map(Block::rows).sum();
        let mut a = DMatrix::zeros(n, n);
        let mut at = 0;
        for block in blocks {
            let width = block.width();
            for k in 0..block.rows() {
                a[(at + k, at + k)] = block.a;
                if k + width < block.rows() {
                    a[(at + k, at + k + width)] = 1;
                }
            }
            for k in (0..block.rows()).step_by(2).filter(|_| width == 2) {
                (a[(at + k, at + k + 1)], a[(at + k + 1, at + k)]) = (block.b, -block.b);
            }
            at += block.rows();
        }
        Similar { a, p: DMatrix::identity(n, n), inverse: DMatrix::identity(n, n) }
    }

    /// Adds c times row j to row i, and takes c times column i from column j; not if entries grow too large.
    fn shear(&mut self, i: usize, j: usize, c: i64) {
        self.add(i, j, c);
        let row = |matrix: &DMatrix<i64>| matrix.row(i).iter().all(|entry| entry.abs() < LARGEST);
        let column = |matrix: &DMatrix<i64>| matrix.column(j).iter().all(|entry| entry.abs() < LARGEST);
        if !(row(&self.a) && column(&self.a) && row(&self.p) && column(&self.inverse)) {
            self.add(i, j, -c);
        }
    }

    fn add(&mut self, i: usize, j: usize, c: i64) {
        for k in 0..self.a.nrows() {
            self.a[(i, k)] += c * self.a[(j, k)];
            self.p[(i, k)] += c * self.p[(j, k)];
        }
        for k in 0..self.a.nrows() {
            self.a[(k, j)] -= c * self.a[(k, i)];
            self.inverse[(k, j)] -= c * self.inverse[(k, i)];
        }
    }
}

impl Exact {
    /// The one of this number.
    pub fn numbered(number: u64) -> Exact {
        let random = &mut Random(number);
        let n = 1 + below(random, 60);
        let mut blocks: Vec<Block> = Vec::new();
        let mut left = n;
        while left > 0 {
            let block = Block::draw(random, left);
            left -= block.rows();
            blocks.push(block);
        }
        let mut similar = Similar::new(&blocks);
        let shears = if n > 1 { below(random, 3 * n + 1) } else { 0 };
        for _ in 0..shears {
            let (i, j) = (below(random, n), below(random, n));
            let c = [-2, -1, 1, 1, 2][below(random, 5)];
            if i != j {
                similar.shear(i, j, c);
            }
        }
        let spread = [0, 8, 30][below(random, 3)];
        let drawn: Vec<f64> = (0..n).map(|_| power(below(random, 2 * spread + 1) as i32 - spread as i32)).collect();
        let whole = power(below(random, 201) as i32 - 100);
        let plain = DMatrix::from_fn(n, n, |i, j| similar.a[(i, j)] as f64 * drawn[i] / drawn[j]);
        let (norm, scales) = balance(plain.clone());
        let right = |i: usize, j: usize| similar.p[(i, j)] as f64 * drawn[i] / scales[i];
        let left = |i: usize, j: usize| similar.inverse[(i, j)] as f64 / drawn[j] * scales[j];
        let mut clusters = clusters(&blocks, norm, &right, &left);
        clusters.iter_mut().flat_map(|cluster| &mut cluster.values).for_each(|value| *value *= whole);
        Exact { matrix: plain * whole, clusters, norm: norm * whole, scales }
    }

    /// The largest error of simple eigenvalues, and of the means of clusters, as parts of what they may be; and the largest
    /// |A x - lambda x| of the eigenvectors x of simple eigenvalues, as a part of |A| |x|; all after balancing.
    pub fn errors(&self, found: &Eigen) -> [f64; 3] {
        if self.norm == 0.0 {
            return [if found.values.iter().all(|value| value.norm() == 0.0) { 0.0 } else { f64::INFINITY }; 3];
        }
        let mut members = vec![Vec::new(); self.clusters.len()];
        for (k, value) in found.values.iter().enumerate() {
            let away = |cluster: &Cluster| {
                cluster.values.iter().map(|exact| (exact - value).norm()).fold(f64::INFINITY, f64::min)
            };
            let all = 0..self.clusters.len();
            let nearest = all.min_by(|i, j| away(&self.clusters[*i]).total_cmp(&away(&self.clusters[*j])));
            members[nearest.unwrap_or_default()].push(k);
        }
        let mut errors = [0.0f64; 3];
        for (cluster, members) in self.clusters.iter().zip(members) {
            let values: Vec<Complex<f64>> = members.iter().map(|k| found.values[*k]).collect();
            let error = match values.len() == cluster.values.len() {
                true => (mean(&values) - mean(&cluster.values)).norm() / (PART * self.norm * cluster.projector()),
                false => f64::INFINITY,
            };
            let kind = usize::from(values.len() > 1);
            errors[kind] = worse(errors[kind], error);
            if let [k] = members[..] {
                errors[2] = worse(errors[2], self.residual(found.values[k], found.vectors.column(k).into()));
            }
        }
        errors
    }

    /// |A x - lambda x| as a part of |A| |x|, after balancing.
    fn residual(&self, value: Complex<f64>, vector: DVector<Complex<f64>>) -> f64 {
        let n = self.scales.len();
        let a = DMatrix::from_fn(n, n, |i, j| Complex::from(self.matrix[(i, j)] / self.scales[i] * self.scales[j]));
        let x = DVector::from_fn(n, |i, _| vector[i] / self.scales[i]).normalize();
        (&a * &x - &x * value).norm() / self.norm
    }
}

/// The larger of two errors; one that is no number is the largest.
fn worse(a: f64, b: f64) -> f64 {
    if b.is_nan() { f64::INFINITY } else { a.max(b) }
}

fn mean(values: &[Complex<f64>]) -> Complex<f64> {
    values.iter().sum::<Complex<f64>>() / values.len() as f64
}

impl Cluster {
    /// The norm of the projector, that of Frobenius.
    fn projector(&self) -> f64 {
        (&self.right * &self.left).norm()
    }

    fn new(
        values: Vec<Complex<f64>>,
        right: DMatrix<Complex<f64>>,
        left: DMatrix<Complex<f64>>,
        order: usize,
        norm: f64,
    ) -> Cluster {
        let perturbation = PERTURBATION * right.norm() * left.norm() * norm;
        let reach = perturbation.max(perturbation.powf(1.0 / order as f64));
        Cluster { values, right, left, order, reach }
    }

    fn join(self, other: Cluster, norm: f64) -> Cluster {
        let n = self.right.nrows();
        let (k, l) = (self.values.len(), other.values.len());
        let mut right = self.right.resize_horizontally(k + l, Complex::default());
        right.view_mut((0, k), (n, l)).copy_from(&other.right);
        let mut left = self.left.resize_vertically(k + l, Complex::default());
        left.view_mut((k, 0), (l, n)).copy_from(&other.left);
        let values = [self.values, other.values].concat();
        Cluster::new(values, right, left, self.order.max(other.order), norm)
    }
}

/// The eigenvalues of Jordan blocks, those together that cannot be told apart. `right` and `left` are P and its inverse.
fn clusters(
    blocks: &[Block],
    norm: f64,
    right: &dyn Fn(usize, usize) -> f64,
    left: &dyn Fn(usize, usize) -> f64,
) -> Vec<Cluster> {
    let n = blocks.iter().map(Block::rows).sum();
    let (mut clusters, mut at): (Vec<Cluster>, usize) = (Vec::new(), 0);
    for block in blocks {
        let (width, first) = (block.width(), at);
        for sign in if width == 1 { vec![0.0] } else { vec![1.0, -1.0] } {
            let share = 1.0 / width as f64;
            let second = |k: usize, of: &dyn Fn(usize) -> f64| if width == 1 { 0.0 } else { of(k + 1) };
            let column = |i: usize, k: usize| Complex::new(right(i, k), sign * second(k, &|k| right(i, k)));
            let row = |k: usize, j: usize| Complex::new(left(k, j), -sign * second(k, &|k| left(k, j))) * share;
            let values = vec![Complex::new(block.a as f64, sign * block.b as f64); block.order];
            let right = DMatrix::from_fn(n, block.order, |i, k| column(i, first + width * k));
            let left = DMatrix::from_fn(block.order, n, |k, j| row(first + width * k, j));
            clusters.push(Cluster::new(values, right, left, block.order, norm));
        }
        at += block.rows();
    }
    loop {
        let pairs = (0..clusters.len()).flat_map(|i| (0..i).map(move |j| (j, i)));
        let are_near = |(j, i): &(usize, usize)| {
            let (a, b) = (&clusters[*j], &clusters[*i]);
            let reach = 2.0 * (a.reach + b.reach);
            a.values.iter().any(|a| b.values.iter().any(|b| (a - b).norm() <= reach))
        };
        let Some((j, i)) = pairs.into_iter().find(are_near) else { return clusters };
        let other = clusters.swap_remove(i);
        let joined = clusters.swap_remove(j).join(other, norm);
        clusters.push(joined);
    }
}

/// Balances a matrix by powers of two until nothing gains a twentieth (Parlett and Reinsch, Numerische Mathematik 13, 1969); gives its norm
/// then, and the scales.
fn balance(mut a: DMatrix<f64>) -> (f64, Vec<f64>) {
    let n = a.nrows();
    let mut scales = vec![1.0; n];
    loop {
        let mut has_changed = false;
        for i in 0..n {
            let (row, column) = (a.row(i).norm(), a.column(i).norm());
            let factor = power(((row / column).log2() / 2.0).round() as i32);
            if row > 0.0 && column > 0.0 && column * factor + row / factor < 0.95 * (row + column) {
                has_changed = true;
                scales[i] *= factor;
                a.column_mut(i).scale_mut(factor);
                a.row_mut(i).unscale_mut(factor);
            }
        }
        if !has_changed {
            return (a.norm(), scales);
        }
    }
}

/// A whole number from 0 to n - 1.
fn below(random: &mut Random, n: usize) -> usize {
    random.between(0.0, n as f64) as usize
}

fn power(exponent: i32) -> f64 {
    2.0f64.powi(exponent)
}

/// What is asked of eigenvalues, with the value for so many matrices, and what it may be at most.
pub fn lines(count: u64) -> Vec<(String, f64, f64)> {
    let (mut errors, mut failed) = ([0.0f64; 3], 0.0);
    for number in 0..count {
        let exact = Exact::numbered(number);
        match eigen(&exact.matrix) {
            Ok(found) => {
                exact.errors(&found).iter().zip(&mut errors).for_each(|(error, most)| *most = worse(*most, *error))
            }
            Err(_) => failed += 1.0,
        }
    }
    let [simple, mean, residual] = errors;
    vec![
        (format!("of {count} matrices, those without eigenvalues"), failed, 0.0),
        ("error of a simple eigenvalue, in 1e-10 norm / |y'x|".into(), simple, 1.0),
        ("error of the mean of a cluster, likewise".into(), mean, 1.0),
        ("|A x - lambda x| of its eigenvector, in |A| |x|".into(), residual, 1e-10),
    ]
}
