//! The words of the language: those that blocks start with, and those that say what a line or a clause is.

use crate::kernel_id::KernelId;

/// The words that may stand at one place.
pub(super) trait Word: Copy + 'static {
    /// All of them, in the order in which they are told.
    fn all() -> Vec<Self>;

    /// How it is written.
    fn text(self) -> &'static str;

    /// The word that is written so.
    fn of(text: &str) -> Option<Self> {
        Self::all().into_iter().find(|word| word.text() == text)
    }

    /// All of them as they are written.
    fn texts() -> Vec<&'static str> {
        Self::all().into_iter().map(Self::text).collect()
    }
}

/// An enum for the words of one place, `Variant "text"` each.
macro_rules! words {
    ($(#[$docs:meta])* $name:ident { $($word:ident $text:literal)* }) => {
        $(#[$docs])*
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub(super) enum $name {
            $($word,)*
        }

        impl Word for $name {
            fn all() -> Vec<$name> {
                vec![$($name::$word),*]
            }

            fn text(self) -> &'static str {
                match self {
                    $($name::$word => $text,)*
                }
            }
        }
    };
}

words! {
    /// The blocks of a declaration.
    Block {
        Coordinates "coordinates"
        Parameters "parameters"
        Bodies "bodies"
        Loads "loads"
        Constraints "constraints"
        Initial "initial"
        Events "events"
        Outputs "outputs"
        Drawing "drawing"
        Kernels "kernels"
        Auxiliary "auxiliary"
        Inputs "inputs"
        Joints "joints"
        Tables "tables"
        Speeds "speeds"
        Run "run"
        Frames "frames"
    }
}

impl Block {
    /// Whether the first word of every line is a name that the line gives.
    pub(super) fn names_lead(self) -> bool {
        match self {
            Block::Coordinates
            | Block::Parameters
            | Block::Inputs
            | Block::Tables
            | Block::Auxiliary
            | Block::Outputs
            | Block::Speeds => true,
            Block::Bodies
            | Block::Loads
            | Block::Constraints
            | Block::Initial
            | Block::Events
            | Block::Drawing
            | Block::Kernels
            | Block::Run
            | Block::Joints
            | Block::Frames => false,
        }
    }

    /// The block that is often called so.
    pub(super) fn often_called(word: &str) -> Option<Block> {
        const CALLED: [(&str, Block); 8] = [
            ("body", Block::Bodies),
            ("forces", Block::Loads),
            ("force", Block::Loads),
            ("load", Block::Loads),
            ("variables", Block::Coordinates),
            ("states", Block::Coordinates),
            ("joint", Block::Joints),
            ("frame", Block::Frames),
        ];
        CALLED.iter().find(|(called, _)| *called == word).map(|(_, block)| *block)
    }
}

words! {
    /// What a body has.
    BodyWord {
        Mass "mass"
        Inertia "inertia"
        Angle "angle"
        Attitude "attitude"
        Free "free"
        Unchecked "unchecked"
    }
}

words! {
    /// What a frame has after its place.
    FrameWord {
        Angle "angle"
        Attitude "attitude"
    }
}

words! {
    /// Lines of `loads`.
    LoadWord {
        Force "force"
        Torque "torque"
        Gravity "gravity"
        Potential "potential"
        Dissipation "dissipation"
        Spring "spring"
        Damper "damper"
        Friction "friction"
    }
}

words! {
    /// Where a spring is without force.
    RestWord {
        Length "length"
        Rest "rest"
    }
}

words! {
    /// Lines of `joints`: in the plane, then in space.
    JointWord {
        Pin "pin"
        Link "link"
        Slot "slot"
        Slide "slide"
        Gear "gear"
        Rack "rack"
        Cam "cam"
        Roll "roll"
        Ball "ball"
        Revolute "revolute"
        Cylindrical "cylindrical"
        Prismatic "prismatic"
        Universal "universal"
        Planar "planar"
        Screw "screw"
        Weld "weld"
    }
}

words! {
    /// Whether what events switch holds.
    ActivityWord {
        Active "active"
        Released "released"
    }
}

words! {
    /// What happens at an event.
    ActionWord {
        Record "record"
        Stop "stop"
        Set "set"
        Swap "swap"
        Activate "activate"
        Release "release"
        Impact "impact"
    }
}

words! {
    /// What a table is between its rows, at its ends and outside.
    TableWord {
        Linear "linear"
        Cubic "cubic"
        Monotone "monotone"
        Natural "natural"
        Clamped "clamped"
        Held "held"
        Continued "continued"
        Periodic "periodic"
    }
}

words! {
    /// Lines of `drawing`.
    ShapeWord {
        Line "line"
        Slider "slider"
        Ground "ground"
        Point "point"
        Circle "circle"
        Curve "curve"
        Spring "spring"
        Damper "damper"
        Trace "trace"
    }
}

/// Lines of `kernels`.
impl Word for KernelId {
    fn all() -> Vec<KernelId> {
        KernelId::optional().collect()
    }

    fn text(self) -> &'static str {
        self.name()
    }
}
