//! stub
use egui::{Color32, FontId, text::{LayoutJob, TextFormat}};
pub struct Symbol(String);
impl Symbol { pub fn parse(s:&str)->Self{Self(s.to_owned())} pub fn plain(&self)->String{self.0.replace('_',"")} pub fn job(&self,size:f32,color:Color32)->LayoutJob{ let mut j=LayoutJob::default(); j.append(&self.plain(),0.0,TextFormat::simple(FontId::new(size,super::fonts::maths()),color)); j} }
