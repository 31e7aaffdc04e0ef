//! The reported places of words, and the instances that they belong to.

use proc_macro2::Span;

/// The words that stand in no fragment and no repetition.
pub(super) const MECHANISM: usize = 0;

/// The instances of fragments and the rounds of repetitions, numbered as they are met.
#[derive(Default)]
pub(super) struct Places {
    /// The name of each instance in messages; the first is the mechanism itself.
    labels: Vec<String>,
    /// The one instance whose words keep their places, and the place of all other words.
    focus: Option<(usize, Span)>,
    /// The number of words.
    pub(super) words: usize,
}

impl Places {
    /// Words keep their places in one instance alone.
    pub(super) fn focused(instance: usize, elsewhere: Span) -> Places {
        Places { labels: vec![], focus: Some((instance, elsewhere)), words: 0 }
    }

    /// The number of instances besides the mechanism itself.
    pub(super) fn len(&self) -> usize {
        self.labels.len()
    }

    /// The name of an instance: "in `left`", "for i = 3".
    pub(super) fn label(&self, instance: usize) -> &str {
        instance.checked_sub(1).and_then(|at| self.labels.get(at)).map_or("", String::as_str)
    }

    /// One more, inside another. Gives its number.
    pub(super) fn enter(&mut self, label: String, inside: usize) -> usize {
        let label = match self.label(inside) {
            "" => label,
            outer => format!("{outer}, {label}"),
        };
        self.labels.push(label);
        self.labels.len()
    }

    /// One more, with a complete name. Gives its number.
    pub(super) fn enter_named(&mut self, label: String) -> usize {
        self.labels.push(label);
        self.labels.len()
    }

    /// Whether words of an instance stand where the user wrote them.
    pub(super) fn are_kept(&self, instance: usize) -> bool {
        self.focus.is_none_or(|(focus, _)| focus == instance)
    }

    /// The reported place of a word of an instance.
    pub(super) fn place(&self, span: Span, instance: usize) -> Span {
        match self.focus {
            Some((focus, elsewhere)) if focus != instance => elsewhere,
            _ => span,
        }
    }
}
