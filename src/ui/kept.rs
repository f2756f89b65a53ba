//! Triangles that are made again only when what they follow from has changed.

use std::fmt::Debug;
use std::hash::Hash;
use std::sync::Arc;

use egui::{Context, Id, Mesh};

/// The triangles called `name`: those of the frame before if they followed from the same `key`, or else what `make` gives.
pub fn kept<K>(ctx: &Context, name: impl Hash + Debug, key: K, make: impl FnOnce() -> Mesh) -> Arc<Mesh>
where
    K: Clone + PartialEq + Send + Sync + 'static,
{
    let id = Id::unique(("kept", name));
    if let Some((of, mesh)) = ctx.data(|data| data.get_temp::<(K, Arc<Mesh>)>(id))
        && of == key
    {
        return mesh;
    }
    let mesh = Arc::new(make());
    ctx.data_mut(|data| data.insert_temp(id, (key, mesh.clone())));
    mesh
}
