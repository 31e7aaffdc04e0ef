//! Declarations in files.

use super::interpret;
use crate::model::erased::Model;
use codegen::Derived;
use codegen::description::kebab_case;
use codegen::dsl::{self, folder_of_tables};
use codegen::mistakes::Mistake;
use proc_macro2::TokenStream;
use sim_import::urdf::{self, Imported};
use std::fs::File;
use std::io::Read;
use std::path::{Component, Path, PathBuf};
use std::sync::{Arc, OnceLock};

/// The largest file that is read, in bytes.
const LARGEST: u64 = 4 << 20;

/// A file that declares mechanisms: one by itself, as the text between the braces of `mechanism! { .. }`, or several in Rust; or
/// a robot in URDF, whose name ends in `.urdf`. It is read once.
#[derive(Clone, Debug)]
pub struct DeclarationFile {
    path: PathBuf,
    text: String,
    /// How a robot is imported.
    robots: urdf::Options,
    /// A robot as a declaration, once it is asked for.
    imported: OnceLock<Result<Imported, Vec<Mistake>>>,
}

/// Why a file gives no mechanism.
#[derive(Clone, Debug, thiserror::Error)]
pub enum LoadError {
    /// It cannot be read.
    #[error("cannot read {path}: {why}", path = path.display())]
    Read {
        /// The file.
        path: PathBuf,
        /// What the system says.
        why: String,
    },
    /// It declares what cannot be.
    #[error("{}", shown(.path, .text, .mistakes))]
    Mistakes {
        /// The file.
        path: PathBuf,
        /// What stands in it.
        text: String,
        /// All mistakes of the first stage that finds any.
        mistakes: Vec<Mistake>,
    },
    /// It has no mechanism of a name, or several and none was chosen.
    #[error("{path} {what}", path = path.display())]
    Choice {
        /// The file.
        path: PathBuf,
        /// What is known.
        what: String,
    },
}

/// Every mistake under its line.
fn shown(path: &Path, text: &str, mistakes: &[Mistake]) -> String {
    let file = path.display().to_string();
    let all: Vec<String> = mistakes.iter().map(|mistake| mistake.shown(&file, text)).collect();
    all.join("\n\nerror: ")
}

/// A mechanism from a file: the one of this name, `FourBar` or `four-bar`, or the only one.
///
/// # Errors
/// If the file cannot be read, has mistakes, or leaves the choice open.
pub fn load(path: impl AsRef<Path>, name: Option<&str>) -> Result<Arc<dyn Model>, LoadError> {
    DeclarationFile::read(path.as_ref())?.model(name)
}

impl DeclarationFile {
    /// Reads a file.
    ///
    /// # Errors
    /// If it cannot be read, is larger than 4 MB, or no text.
    pub fn read(path: &Path) -> Result<DeclarationFile, LoadError> {
        let fail = |why: String| LoadError::Read { path: path.to_owned(), why };
        let file = File::open(path).map_err(|why| fail(why.to_string()))?;
        let mut bytes = Vec::new();
        file.take(LARGEST + 1).read_to_end(&mut bytes).map_err(|why| fail(why.to_string()))?;
        if bytes.len() as u64 > LARGEST {
            return Err(fail(format!("it has more than {} MB, and declarations are shorter", LARGEST >> 20)));
        }
        let text = String::from_utf8(bytes).map_err(|_| fail("it is no text in UTF-8".to_owned()))?;
        Ok(DeclarationFile::of(path, text))
    }

    /// A text, as if it stood in a file of this path. Tables are sought beside it.
    pub fn of(path: &Path, text: String) -> DeclarationFile {
        // Places are counted without the mark that some editors put first.
        let text = text.strip_prefix('\u{feff}').map_or_else(|| text.clone(), str::to_owned);
        DeclarationFile { path: path.to_owned(), text, robots: urdf::Options::default(), imported: OnceLock::new() }
    }

    /// The same file, its robot imported so.
    pub fn with_robots(self, robots: urdf::Options) -> DeclarationFile {
        DeclarationFile { robots, imported: OnceLock::new(), ..self }
    }

    /// Whether it describes a robot.
    pub fn is_robot(&self) -> bool {
        self.path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("urdf"))
    }

    /// A robot as a declaration, with what its file lacks or contradicts.
    ///
    /// # Errors
    /// What is no robot, at its place.
    pub fn robot(&self) -> Result<&Imported, LoadError> {
        self.imported().map_err(|mistakes| self.mistaken(mistakes))
    }

    fn imported(&self) -> Result<&Imported, Vec<Mistake>> {
        let folder = self.path.parent().unwrap_or(Path::new(""));
        let import = || urdf::import(&self.text, folder, &self.robots);
        self.imported.get_or_init(import).as_ref().map_err(Clone::clone)
    }

    /// What a robot's file lacks or contradicts, each under its line; nothing of other files.
    pub fn warnings(&self) -> Vec<String> {
        let robot = if self.is_robot() { self.imported().ok() } else { None };
        let file = self.path.display().to_string();
        robot.iter().flat_map(|robot| &robot.warnings).map(|warning| warning.shown(&file, &self.text)).collect()
    }

    /// Its text.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The mechanism of this name, `FourBar` or `four-bar`, or the only one.
    ///
    /// # Errors
    /// As [`load`].
    pub fn model(&self, name: Option<&str>) -> Result<Arc<dyn Model>, LoadError> {
        let declared = self.declarations().map_err(|mistakes| self.mistaken(mistakes))?;
        let names = || declared.iter().map(|declared| declared.name.as_str()).collect::<Vec<_>>().join(", ");
        let choice = |what: String| LoadError::Choice { path: self.path.clone(), what };
        let is_called = |own: &str| name.is_none_or(|name| name == own || name == kebab_case(own));
        let chosen: Vec<&Declared> = declared.iter().filter(|declared| is_called(&declared.name)).collect();
        match chosen.as_slice() {
            [one] => Ok(interpret(&self.derive(one).map_err(|mistakes| self.mistaken(mistakes))?)),
            [] => Err(choice(format!("declares no `{}`, but {}", name.unwrap_or_default(), names()))),
            [first, ..] => {
                let path = self.path.display();
                Err(choice(format!("declares {}: choose one, as in `{path}:{}`", names(), first.name)))
            }
        }
    }

    /// The names of its mechanisms, if it has no mistakes.
    ///
    /// # Errors
    /// All mistakes of all its mechanisms.
    pub fn check(&self) -> Result<Vec<String>, Vec<Mistake>> {
        let declared = self.declarations()?;
        let found: Vec<Mistake> = declared.iter().filter_map(|one| self.derive(one).err()).flatten().collect();
        if found.is_empty() { Ok(declared.into_iter().map(|one| kebab_case(&one.name)).collect()) } else { Err(found) }
    }

    /// The tables that its declarations name, in the folder where tables are read or below; elsewhere none is read.
    pub fn tables(&self) -> Vec<PathBuf> {
        let folder = folder_of_tables(&self.path);
        // A robot has none.
        let declared = dsl::declarations(&self.text).unwrap_or_default();
        let paths = declared.into_iter().flat_map(dsl::files_named);
        let is_below = |path: &PathBuf| path.components().all(|part| matches!(part, Component::Normal(_)));
        paths.map(PathBuf::from).filter(is_below).map(|path| folder.join(path)).collect()
    }

    fn declarations(&self) -> Result<Vec<Declared>, Vec<Mistake>> {
        let text = if self.is_robot() { &self.imported()?.text } else { &self.text };
        let all = dsl::declarations(text).map_err(self.of_kind("E-TEXT"))?;
        let named = |tokens: TokenStream| {
            let name = dsl::parse_head(tokens.clone()).map_err(self.of_kind("E-FORM"))?.name.to_string();
            Ok(Declared { name, tokens })
        };
        all.into_iter().map(named).collect()
    }

    fn derive(&self, declared: &Declared) -> Result<Derived, Vec<Mistake>> {
        let read = dsl::read_files(declared.tokens.clone(), &folder_of_tables(&self.path));
        let (tokens, _) = read.map_err(self.of_kind("E-TABLE"))?;
        codegen::derive(tokens.clone()).map_err(|mistakes| {
            let is_form = codegen::parse(tokens).is_err();
            self.of_kind(if is_form { "E-FORM" } else { "E-MEANING" })(mistakes)
        })
    }

    fn of_kind(&self, code: &'static str) -> impl Fn(codegen::Mistaken) -> Vec<Mistake> {
        move |mistakes| match self.is_robot() {
            true => vec![self.unfit(&mistakes)],
            false => Mistake::all(&self.text, code, mistakes),
        }
    }

    /// Why a robot's declaration is none: its places are not those of the robot's file.
    fn unfit(&self, mistakes: &codegen::Mistaken) -> Mistake {
        let message = format!("this robot cannot be declared: {mistakes}\n`sim import` writes its declaration");
        Mistake::at(&self.text, "E-URDF", urdf::root(&self.text), message)
    }

    fn mistaken(&self, mistakes: Vec<Mistake>) -> LoadError {
        LoadError::Mistakes { path: self.path.clone(), text: self.text.clone(), mistakes }
    }
}

/// A declaration of a file.
struct Declared {
    name: String,
    tokens: TokenStream,
}
