//! Exact numbers against rationals of arbitrary precision, and against decimal literals of the platform.

use crate::harness::{Verdict, check};
use codegen::symbolic::Number;
use num_bigint::BigInt;
use num_integer::Integer;
use num_rational::BigRational;
use num_traits::Signed;
use proptest::prelude::*;

const CASES: u32 = 4000;

/// Numbers on both sides of the limit up to which they are kept in words.
fn word() -> impl Strategy<Value = i64> {
    let near_the_limit = prop_oneof![i64::MIN..i64::MIN + 3, i64::MAX - 3..=i64::MAX];
    prop_oneof![-12i64..=12, near_the_limit, any::<i64>(), any::<i32>().prop_map(i64::from)]
}

fn fraction() -> impl Strategy<Value = (Number, BigRational)> {
    (word(), word().prop_filter("denominator", |d| *d != 0)).prop_map(|(n, d)| {
        let number = Number::fraction(n, d).expect("a denominator that is not zero");
        (number, BigRational::new(n.into(), d.into()))
    })
}

/// Equal in value, and in the form that hashing sees.
fn same(number: &Number, right: &BigRational) -> bool {
    let (p, q) = (right.numer(), right.denom());
    let fits = i64::try_from(p).ok().zip(i64::try_from(q).ok());
    number.to_string() == right.to_string()
        && number.to_fraction() == fits
        && number.is_negative() == right.is_negative()
}

#[test]
fn arithmetic_is_exact() {
    check(CASES, 100, (fraction(), fraction(), -5i64..=5), |((a, big_a), (b, big_b), exponent)| {
        prop_assert!(same(&(&a + &b), &(&big_a + &big_b)));
        prop_assert!(same(&(&a - &b), &(&big_a - &big_b)));
        prop_assert!(same(&(&a * &b), &(&big_a * &big_b)));
        prop_assert!(same(&-&a, &-&big_a));
        prop_assert!(same(&a.abs(), &big_a.abs()));
        prop_assert_eq!(a.cmp(&b), big_a.cmp(&big_b));
        prop_assert_eq!(a.is_integer(), big_a.is_integer());
        match a.pow(exponent) {
            Some(power) => prop_assert!(same(&power, &big_a.pow(exponent as i32))),
            None => prop_assert!(a.is_zero() && exponent < 0),
        }
        match a.recip() {
            Some(inverse) => prop_assert!(same(&inverse, &big_a.recip())),
            None => prop_assert!(a.is_zero()),
        }
        Ok(Verdict::Holds)
    });
}

#[test]
fn operations_can_be_undone() {
    check(CASES, 100, (fraction(), fraction()), |((a, _), (b, _))| {
        prop_assert_eq!(&(&(&a + &b) - &b), &a);
        if let Some(inverse) = b.recip() {
            prop_assert_eq!(&(&(&a * &b) * &inverse), &a);
        }
        Ok(Verdict::Holds)
    });
}

#[test]
fn the_greatest_common_divisor_divides_and_leaves_coprime_integers() {
    check(CASES, 100, (fraction(), fraction()), |((a, _), (b, _))| {
        let divisor = a.gcd(&b);
        let Some(inverse) = divisor.recip() else {
            prop_assert!(a.is_zero() && b.is_zero());
            return Ok(Verdict::Holds);
        };
        prop_assert!(!divisor.is_negative());
        let [a, b] = [a, b].map(|number| (&number * &inverse).to_string().parse::<BigInt>().expect("an integer"));
        prop_assert_eq!(a.gcd(&b), BigInt::from(1));
        Ok(Verdict::Holds)
    });
}

#[test]
fn exact_roots_are_those_of_powers() {
    check(CASES, 100, (fraction(), 2u32..6), |((a, _), degree)| {
        let power = a.pow(degree.into()).expect("a small power");
        prop_assert_eq!(power.exact_root(degree), (!power.is_negative()).then(|| a.abs()));
        // There is nothing between the powers of neighbouring integers.
        let beside = &power + &Number::ONE;
        if a.is_integer() && a > Number::ZERO {
            prop_assert_eq!(beside.exact_root(degree), None);
        }
        Ok(Verdict::Holds)
    });
}

#[test]
fn decimal_literals_round_as_those_of_the_platform() {
    // Those without an exponent are often fractions of two words.
    let exponent = prop_oneof![-330i32..300, Just(0)];
    let literal = (any::<u64>(), 0usize..20, exponent).prop_map(|(digits, decimals, exponent)| {
        let digits = format!("{digits:020}");
        let (whole, fraction) = digits.split_at(20 - decimals);
        format!("{whole}.{fraction}e{exponent}")
    });
    check(CASES, 90, literal, |literal| {
        let value: f64 = literal.parse().expect("a literal");
        let Some(number) = Number::parse_decimal(&literal) else {
            prop_assert!(value.is_infinite() || value == 0.0);
            return Ok(Verdict::Open);
        };
        prop_assert_eq!(number.to_f64(), value);
        Ok(Verdict::Holds)
    });
}

/// A power of ten is what it is, whether its zeros are written or counted, up to as many as are read.
#[test]
fn zeros_of_decimal_literals_may_be_written_or_counted() {
    for (exponent, zeros) in [(700, 0), (700, 399), (699, 398), (400, 399), (12, 12)] {
        let written = format!("1{}e-{exponent}", "0".repeat(zeros));
        let counted = format!("1e{}", zeros as i32 - exponent);
        let expected = Number::from(10).pow(i64::from(zeros as i32 - exponent));
        let is_in_range = counted.parse::<f64>().expect("a literal") > 0.0;
        assert_eq!(Number::parse_decimal(&written), expected.filter(|_| is_in_range), "{written}");
        assert_eq!(Number::parse_decimal(&written), Number::parse_decimal(&counted), "{written}");
    }
}
