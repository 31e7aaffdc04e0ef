//! The hash of a declaration: the same for the same words, wherever they come from and however they are laid out.
//!
//! FNV-1a with 128 bits (Fowler, Noll, Vo; RFC 9923) over the declaration's words as UTF-8, a line feed after each. A word is a
//! name, a number as it is written, a bracket, or one mark of punctuation; text in quotes and documentation count by what they
//! say. Rows of a table that stands in a file count as if they were written out. The hash tells declarations apart; it is no
//! protection against forgery.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};

/// The hash of a declaration's tokens, its files read in, in 32 hexadecimal digits.
pub fn hash(tokens: TokenStream) -> String {
    let mut hash = Fnv::new();
    add(tokens, &mut hash);
    format!("{:032x}", hash.0)
}

fn add(tokens: TokenStream, hash: &mut Fnv) {
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(mark) => {
                let documentation = match tokens.peek() {
                    Some(TokenTree::Group(group)) if mark.as_char() == '#' => documentation(group),
                    _ => None,
                };
                match documentation {
                    Some(text) => {
                        tokens.next();
                        hash.add_word(&format!("///{}", text.trim()));
                    }
                    None => hash.add_word(mark.as_char().encode_utf8(&mut [0; 4])),
                }
            }
            TokenTree::Group(group) => {
                let (open, close) = match group.delimiter() {
                    Delimiter::Parenthesis => ("(", ")"),
                    Delimiter::Brace => ("{", "}"),
                    Delimiter::Bracket => ("[", "]"),
                    // What a macro has put around its argument, and nobody has written.
                    Delimiter::None => ("", ""),
                };
                hash.add_word(open);
                add(group.stream(), hash);
                hash.add_word(close);
            }
            TokenTree::Literal(literal) => match syn::Lit::new(literal.clone()) {
                // With or without escapes.
                syn::Lit::Str(text) => hash.add_word(&format!("{:?}", text.value())),
                _ => hash.add_word(&literal.to_string()),
            },
            TokenTree::Ident(name) => hash.add_word(&name.to_string()),
        }
    }
}

/// The text of `[doc = ".."]`, on one line or several.
pub(super) fn documentation(group: &Group) -> Option<String> {
    let attribute: syn::MetaNameValue = syn::parse2(group.stream()).ok()?;
    match attribute.value {
        syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) if attribute.path.is_ident("doc") => {
            Some(text.value())
        }
        _ => None,
    }
}

struct Fnv(u128);

impl Fnv {
    fn new() -> Fnv {
        Fnv(0x6c62_272e_07bb_0142_62b8_2175_6295_c58d)
    }

    fn add(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u128::from(*byte)).wrapping_mul(0x0000_0000_0100_0000_0000_0000_0000_013b);
        }
    }

    fn add_word(&mut self, word: &str) {
        if !word.is_empty() {
            self.add(word.as_bytes());
            self.add(b"\n");
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Test vectors of RFC 9923.
    #[test]
    fn the_hash_is_fnv_1a() {
        let of = |text: &str| {
            let mut hash = Fnv::new();
            hash.add(text.as_bytes());
            format!("{:032x}", hash.0)
        };
        assert_eq!(of(""), "6c62272e07bb014262b821756295c58d");
        assert_eq!(of("a"), "d228cb696f1a8caf78912b704e4a8964");
        assert_eq!(of("foobar"), "343e1662793c64bf6f0d3597ba446f18");
        assert_eq!(hash("l = 0.2;".parse().unwrap()), of("l\n=\n0.2\n;\n"));
    }

    fn of(text: &str) -> String {
        hash(text.parse().unwrap())
    }

    const TEXT: &str = "/// A bob.\npub Bob; parameters { l [m] = 0.2; } outputs { g \"Two words\" { y [m] = -l; } }";

    #[test]
    fn layout_and_comments_do_not_count() {
        let laid_out = "///A bob.  \n pub   Bob ; // whose rod is light\n parameters\n{\n  l[m]=0.2;/* short */\n}\n\
                        outputs{g \"Two words\"{y[m]= - l;}}";
        assert_eq!(of(laid_out), of(TEXT));
        // As the compiler gives documentation to a macro.
        let attribute = TEXT.replace("/// A bob.", "#[doc = r\" A bob.\"]");
        assert_eq!(of(&attribute), of(TEXT));
        assert_eq!(of(&TEXT.replace("\"Two words\"", "\"Two\\u{20}words\"")), of(TEXT));
        let inner = proc_macro2::Group::new(Delimiter::None, TEXT.parse().unwrap());
        assert_eq!(hash(TokenTree::Group(inner).into()), of(TEXT));
    }

    #[test]
    fn every_word_counts() {
        let others =
            [("0.2", "0.3"), ("0.2", "0.20"), ("[m] = 0", "[mm] = 0"), ("-l", "l"), ("bob", "bar"), ("Two ", "Two")];
        for (word, other) in others.into_iter().chain([("{ l", "l {"), ("pub Bob", "pubBob")]) {
            assert_ne!(of(&TEXT.replacen(word, other, 1)), of(TEXT), "{word} {other}");
        }
    }
}
