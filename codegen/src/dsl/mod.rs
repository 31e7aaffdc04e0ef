//! Stage 1: text to parsed declaration, with the place of every word kept.

mod block;
mod choice;
mod declarations;
mod event;
mod expression;
mod file;
mod frame;
mod free;
mod joint;
mod limits;
mod load;
mod made;
mod parse;
mod print;
mod rates;
mod region;
mod reuse;
mod source;
mod spatial_joint;
mod syntax;
mod table;
mod tree;
mod unit;

pub use declarations::declarations;
pub use event::{Action, Direction, Event};
pub use file::read_files;
pub use joint::{Guide, Joint, JointKind};
pub use parse::{Head, parse, parse_head};
pub use region::Region;
pub use reuse::attributed;
pub use source::source_text;
pub use spatial_joint::{Rolling, Side, SpatialJoint, SpatialKind};
pub use syntax::*;
pub use tree::*;
pub use unit::parse_unit;
