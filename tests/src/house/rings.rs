//! Rings of imports: strongly connected components with more than one module (Tarjan, 1972).

use super::imports::Imports;
use std::collections::BTreeMap;

/// Modules that import each other, directly or by way of others; each ring in order of names.
pub fn rings(imports: &Imports) -> Vec<Vec<String>> {
    let mut search =
        Search { imports, numbers: BTreeMap::new(), lowest: BTreeMap::new(), stack: Vec::new(), rings: Vec::new() };
    for module in imports.keys() {
        if !search.numbers.contains_key(module.as_str()) {
            search.visit(module);
        }
    }
    search.rings
}

struct Search<'i> {
    imports: &'i Imports,
    /// The order in which modules were first visited.
    numbers: BTreeMap<&'i str, usize>,
    /// The lowest number that can be come to from each.
    lowest: BTreeMap<&'i str, usize>,
    stack: Vec<&'i str>,
    rings: Vec<Vec<String>>,
}

impl<'i> Search<'i> {
    fn visit(&mut self, module: &'i str) {
        let number = self.numbers.len();
        self.numbers.insert(module, number);
        self.stack.push(module);
        let mut lowest = number;
        for other in self.imports.get(module).into_iter().flatten() {
            match self.numbers.get(other.as_str()) {
                None => {
                    self.visit(other);
                    lowest = lowest.min(self.lowest[other.as_str()]);
                }
                Some(number) if self.stack.contains(&other.as_str()) => lowest = lowest.min(*number),
                Some(_) => {}
            }
        }
        self.lowest.insert(module, lowest);
        if lowest == number {
            let first = self.stack.iter().position(|other| *other == module).unwrap_or(0);
            let mut ring: Vec<String> = self.stack.drain(first..).map(str::to_owned).collect();
            ring.sort();
            if ring.len() > 1 {
                self.rings.push(ring);
            }
        }
    }
}
