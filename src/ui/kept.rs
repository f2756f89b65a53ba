//! What is drawn again only when what it follows from has changed: triangles, for the most part.

use std::fmt::Debug;
use std::hash::Hash;
use std::sync::Arc;

use egui::{Context, Id};

/// The value called `name`: that of the frame before if it followed from the same `key`, or else a new one by `make`.
pub fn kept<K, T>(ctx: &Context, name: impl Hash + Debug, key: K, make: impl FnOnce() -> T) -> Arc<T>
where
    K: Clone + PartialEq + Send + Sync + 'static,
    T: Send + Sync + 'static,
{
    let id = Id::unique(("kept", name));
    if let Some((of, made)) = ctx.data(|data| data.get_temp::<(K, Arc<T>)>(id))
        && of == key
    {
        return made;
    }
    let made = Arc::new(make());
    ctx.data_mut(|data| data.insert_temp(id, (key, made.clone())));
    made
}
