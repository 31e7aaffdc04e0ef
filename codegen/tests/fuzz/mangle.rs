//! Declarations with words left out, doubled, exchanged and replaced.

use crate::random::Random;
use crate::{plane, space};
use proc_macro2::{Group, TokenStream, TokenTree};
use quote::quote;
use std::panic::catch_unwind;
use std::path::Path;
use std::time::{Duration, Instant};
use std::{fs, iter};

const CASES: usize = 500;

/// What is put in for other words.
const WORDS: &str = "x y q_1 t pi e 0 1 2.5 1e400 99999999999999999999 -1 [m] [rad] [kg*m^2] [x, y] [] () {} (x) ; , : . = + - * \
    / ^ .. ..= % ! # & -> => dot ddot reaction norm sin sqrt atan2 let use as fragment repeat in sum const at on mass inertia \
    angle force torque gravity guess coordinates parameters bodies loads constraints initial events outputs drawing \
    kernels line slider tables over linear cubic periodic natural held from joints cam by free attitude \
    rotation(z, t) euler quaternion axes transpose omega cross revolute ball to axis ground pitch R*[x, y, 1] \
    \"title\" 'c' r#type \
    _ self P_[0] q_[i] repeat i in 1..=3 { } use A as b; x^99 1/0 (((x))) if else";

/// Sound declarations: random ones, the models, and the examples of the language's reference.
fn declarations() -> Vec<TokenStream> {
    let workspace = Path::new(env!("CARGO_MANIFEST_DIR")).parent().unwrap();
    let models = fs::read_dir(workspace.join("models/src")).unwrap().map(|entry| entry.unwrap().path());
    let mut models: Vec<_> = models.filter(|path| !path.ends_with("lib.rs")).collect();
    models.sort();
    let mut texts: Vec<String> = models.iter().map(|path| fs::read_to_string(path).unwrap()).collect();
    let reference = fs::read_to_string(workspace.join("LANGUAGE.md")).unwrap();
    let examples = reference.split("```rust\n").skip(1).filter_map(|rest| rest.split("```").next());
    texts.extend(examples.filter(|text| text.contains("mechanism!")).map(str::to_owned));
    let random = (0..20).flat_map(|seed| [plane::declaration("Fuzz", seed), space::declaration("Fuzz", seed)]);
    texts.iter().cloned().chain(random).flat_map(|text| codegen::dsl::declarations(&text).unwrap()).collect()
}

#[test]
fn mangled_declarations_are_refused_or_understood() {
    let declarations = declarations();
    let words: Vec<TokenTree> = WORDS.parse::<TokenStream>().unwrap().into_iter().collect();
    let (mut slowest, mut refused) = (Duration::ZERO, 0);
    for seed in 0..CASES * crate::scale() {
        let mut random = Random::new(seed + 1_000_000);
        let mut mangled = random.pick(&declarations).clone();
        for _ in 0..1 + random.below(3) {
            mangled = mangle(mangled, &words, &mut random);
        }
        let text = codegen::dsl::source_text(mangled.clone());
        let clock = Instant::now();
        let result = catch_unwind(|| codegen::generate(mangled, &quote!(sim_kernel)).map(|_| ()));
        slowest = slowest.max(clock.elapsed());
        match result {
            Err(_) => panic!("seed {seed} panics:\n{text}"),
            Ok(Err(mistakes)) => {
                refused += 1;
                assert!(mistakes.into_iter().all(|mistake| !mistake.to_string().is_empty()), "{text}");
            }
            Ok(Ok(())) => {}
        }
    }
    println!("{} cases, {refused} refused, the slowest took {slowest:?}", CASES * crate::scale());
}

/// One change, somewhere.
fn mangle(tokens: TokenStream, words: &[TokenTree], random: &mut Random) -> TokenStream {
    let mut tokens: Vec<TokenTree> = tokens.into_iter().collect();
    let groups: Vec<usize> = (0..tokens.len()).filter(|i| matches!(tokens[*i], TokenTree::Group(_))).collect();
    // Most words stand inside of brackets.
    if !groups.is_empty() && !random.once_in(4) {
        let at = *random.pick(&groups);
        if let TokenTree::Group(group) = &tokens[at] {
            let mut changed = Group::new(group.delimiter(), mangle(group.stream(), words, random));
            changed.set_span(group.span());
            tokens[at] = changed.into();
        }
        return tokens.into_iter().collect();
    }
    let (at, other) = (random.below(tokens.len()), random.below(tokens.len()));
    let word = random.pick(words).clone();
    match random.below(5) {
        _ if tokens.is_empty() => tokens.push(word),
        0 => drop(tokens.remove(at)),
        1 => tokens.insert(at, tokens[other].clone()),
        2 => tokens.swap(at, other),
        3 => drop(tokens.splice(at..=at, iter::once(word))),
        _ => tokens.insert(at, word),
    }
    tokens.into_iter().collect()
}
