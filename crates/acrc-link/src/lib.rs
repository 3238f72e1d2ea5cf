//! The host's side of a controller, real or virtual: connections, what is read and written over them, download and upload.
