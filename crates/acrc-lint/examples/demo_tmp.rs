use acrc_analysis::{Database, project};
use acrc_diagnostics::*;
fn main(){ let p=project::load(camino::Utf8PathBuf::from(std::env::args().nth(1).unwrap())).unwrap_or_else(|e|{println!("{e}");std::process::exit(1)}); let db=Database::new(); let pr=p.add_to(&db);
 for (f,d) in acrc_lint::check(&db,pr){ let r=FileReport::new(acrc_diagnostics::SourceFile::new(f.name(&db),f.text(&db)),&d); concise::render(&[r],&mut std::io::stdout()).unwrap(); } }
