//! Meshes in STL: their vertices. They are read to be drawn, so whatever is wrong is told and nothing more.

use nalgebra::Vector3;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

/// The largest file that is read, in bytes.
const LARGEST: u64 = 64 << 20;

/// A binary STL begins with a comment of 80 bytes and the number of triangles; each has a normal, three vertices and two bytes.
const HEAD: usize = 84;
const TRIANGLE: usize = 50;

/// Where the file of a mesh is: `package://NAME/..` in the folder of that package, any other name in the robot's folder.
///
/// # Errors
/// What the file lacks to be read: it is elsewhere, or of another kind.
pub(super) fn find(name: &str, folder: &Path, packages: &[(String, PathBuf)]) -> Result<PathBuf, Missing> {
    let is_stl = Path::new(name).extension().is_some_and(|extension| extension.eq_ignore_ascii_case("stl"));
    if !is_stl {
        return Err(Missing::OtherKind);
    }
    let (folder, inside) = match name.strip_prefix("package://") {
        Some(rest) => {
            let (package, inside) = rest.split_once('/').unwrap_or((rest, ""));
            let known = packages.iter().find(|(known, _)| known == package);
            let (_, folder) = known.ok_or_else(|| Missing::Package(package.to_owned()))?;
            (folder.as_path(), inside)
        }
        None => (folder, name.strip_prefix("file://").unwrap_or(name)),
    };
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let inner = |path: &Path| path.canonicalize().map_err(|why| Missing::File(why.to_string()));
    let (path, folder) = (inner(&folder.join(inside))?, inner(folder)?);
    if path.starts_with(&folder) { Ok(path) } else { Err(Missing::Outside) }
}

/// Why a mesh is not drawn.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) enum Missing {
    /// Its package has no known folder.
    Package(String),
    /// It is no STL.
    OtherKind,
    /// It is not in the folder of the robot or of its package.
    Outside,
    /// It cannot be read.
    File(String),
}

/// The vertices of a mesh.
///
/// # Errors
/// If the file cannot be read or is no STL.
pub(super) fn vertices(path: &Path) -> Result<Vec<Vector3<f64>>, Missing> {
    let fail = |why: std::io::Error| Missing::File(why.to_string());
    if !path.is_file() {
        return Err(Missing::File("it is no file".to_owned()));
    }
    let mut bytes = Vec::new();
    File::open(path).map_err(fail)?.take(LARGEST + 1).read_to_end(&mut bytes).map_err(fail)?;
    if bytes.len() as u64 > LARGEST {
        return Err(Missing::File(format!("it has more than {} MB", LARGEST >> 20)));
    }
    let found = binary(&bytes).or_else(|| in_words(&bytes)).ok_or_else(|| Missing::File("it is no STL".to_owned()))?;
    let finite: Vec<Vector3<f64>> = found.into_iter().filter(|at| at.iter().all(|x| x.is_finite())).collect();
    if finite.is_empty() { Err(Missing::File("it has no triangles".to_owned())) } else { Ok(finite) }
}

fn binary(bytes: &[u8]) -> Option<Vec<Vector3<f64>>> {
    let number = |at: usize| Some(f32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?) as f64);
    let count = u32::from_le_bytes(bytes.get(HEAD - 4..HEAD)?.try_into().ok()?) as usize;
    if count.checked_mul(TRIANGLE)?.checked_add(HEAD)? > bytes.len() {
        return None;
    }
    let corner = |triangle: usize, corner: usize| {
        let at = HEAD + TRIANGLE * triangle + 12 * (corner + 1);
        Some(Vector3::new(number(at)?, number(at + 4)?, number(at + 8)?))
    };
    (0..3 * count).map(|at| corner(at / 3, at % 3)).collect()
}

/// `vertex x y z`, three times in each `facet`.
fn in_words(bytes: &[u8]) -> Option<Vec<Vector3<f64>>> {
    let text = std::str::from_utf8(bytes).ok().filter(|text| text.trim_start().starts_with("solid"))?;
    let (mut words, mut found) = (text.split_ascii_whitespace(), Vec::new());
    while words.by_ref().any(|word| word == "vertex") {
        let mut number = || words.next()?.parse::<f64>().ok();
        found.push(Vector3::new(number()?, number()?, number()?));
    }
    Some(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_kinds_of_stl_are_read() {
        let words = b"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 2.5 0\nendloop\nendfacet\nendsolid a\n";
        let expected = vec![Vector3::zeros(), Vector3::new(1.0, 0.0, 0.0), Vector3::new(0.0, 2.5, 0.0)];
        assert_eq!(in_words(words), Some(expected.clone()));
        let mut bytes = vec![0; 80];
        bytes.extend(1u32.to_le_bytes());
        for number in
            [0.0, 0.0, 1.0].into_iter().chain(expected.iter().flat_map(|at| at.iter().copied().collect::<Vec<_>>()))
        {
            bytes.extend((number as f32).to_le_bytes());
        }
        bytes.extend([0, 0]);
        assert_eq!(binary(&bytes), Some(expected));
        // One triangle less than the head says.
        assert_eq!(binary(&bytes[..100]), None);
        assert_eq!(binary(&[255; 84]), None);
    }

    #[test]
    fn meshes_are_sought_nowhere_else() {
        let folder = std::env::temp_dir();
        let of = |name: &str| find(name, &folder, &[]);
        assert_eq!(of("package://arm/a.stl"), Err(Missing::Package("arm".into())));
        assert_eq!(of("a.dae"), Err(Missing::OtherKind));
        assert_eq!(of("package://arm/a.dae"), Err(Missing::OtherKind));
        assert!(matches!(of("no-such-mesh.stl"), Err(Missing::File(_))));
        let inside = folder.join("linkwright-mesh-inside");
        std::fs::create_dir_all(&inside).unwrap();
        std::fs::write(folder.join("linkwright-mesh.stl"), "").unwrap();
        assert_eq!(find("../linkwright-mesh.stl", &inside, &[]), Err(Missing::Outside));
    }
}
