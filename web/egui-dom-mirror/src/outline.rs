//! What one frame's tree comes to in the page: which elements there are, and in what order they stand.

use std::collections::{HashMap, HashSet};

use egui::accesskit::{Node, NodeId, Role, TreeUpdate};

use crate::kind::Kind;
use crate::picture::Picture;

/// The elements of one frame.
#[derive(Debug)]
pub struct Outline {
    /// Each element, in the order of the tree.
    pub pictures: Vec<(NodeId, Picture)>,
    /// Elements by what holds them, in order; those held inside come before what holds them, the root (`None`) last.
    pub orders: Vec<(Option<NodeId>, Vec<NodeId>)>,
}

impl Outline {
    /// Outline of a whole tree, at a number of CSS pixels a point; `None` for an update without a root.
    pub fn of(update: &TreeUpdate, zoom: f64) -> Option<Self> {
        let root = update.tree.as_ref()?.root;
        let nodes: HashMap<NodeId, &Node> = update.nodes.iter().map(|(id, node)| (*id, node)).collect();
        let is_open = |node: &&&Node| node.role() == Role::ComboBox && node.is_expanded() == Some(true);
        let open = nodes.values().find(is_open).and_then(|node| node.label()).unwrap_or_default().to_owned();
        let mut tree = Tree {
            nodes,
            open,
            zoom,
            seen: HashSet::new(),
            headings: Vec::new(),
            outline: Self { pictures: Vec::new(), orders: Vec::new() },
        };
        let mut children = Vec::new();
        tree.read(root, None, &mut children);
        tree.outline.orders.push((None, children));
        Some(tree.outline)
    }
}

/// A tree that is being read.
struct Tree<'a> {
    nodes: HashMap<NodeId, &'a Node>,
    /// Name of the combo box whose list is open.
    open: String,
    zoom: f64,
    seen: HashSet<NodeId>,
    /// Levels of the headings that the one before stands under, its own last.
    headings: Vec<usize>,
    outline: Outline,
}

impl Tree<'_> {
    /// Names the element of this node in `siblings`, if it has one; then those inside it.
    fn read(&mut self, id: NodeId, holder: Option<Kind>, siblings: &mut Vec<NodeId>) {
        let Some(&node) = self.nodes.get(&id) else {
            return;
        };
        if node.is_hidden() || node.role() == Role::TextRun || self.seen.contains(&id) {
            return;
        }
        // A menu with fields in it is none: it may hold items only.
        let is_menu = node.role() != Role::Menu || self.holds_only(node, &[Role::Button, Role::MenuItem]);
        let picture = is_menu.then(|| Picture::of(node, holder, &self.name(node), self.zoom)).flatten();
        let Some(mut picture) = picture else {
            return self.read_inside(node, holder, siblings);
        };
        if let Kind::Heading(level) = picture.kind {
            picture.kind = Kind::Heading(self.depth(level));
        }
        let kind = picture.kind;
        self.seen.insert(id);
        siblings.push(id);
        self.outline.pictures.push((id, picture));
        if kind.holds() {
            let mut children = Vec::new();
            self.read_inside(node, Some(kind), &mut children);
            self.outline.orders.push((Some(id), children));
        } else {
            // What lies inside a widget comes after it.
            self.read_inside(node, holder, siblings);
        }
    }

    fn read_inside(&mut self, node: &Node, holder: Option<Kind>, siblings: &mut Vec<NodeId>) {
        for &child in node.children() {
            self.read(child, holder, siblings);
        }
    }

    /// How deep a heading of this level stands under those before it: no level is left out, whatever the page calls them.
    fn depth(&mut self, level: usize) -> usize {
        self.headings.retain(|above| *above < level);
        self.headings.push(level);
        self.headings.len()
    }

    /// Whether nothing in it has a role of its own but these; what arranges others has none.
    fn holds_only(&self, node: &Node, roles: &[Role]) -> bool {
        node.children().iter().filter_map(|child| self.nodes.get(child)).all(|child| {
            let is_one = matches!(child.role(), Role::GenericContainer | Role::Splitter | Role::TextRun)
                || child.is_hidden()
                || roles.contains(&child.role());
            is_one && self.holds_only(child, roles)
        })
    }

    /// The first heading in it.
    fn heading(&self, node: &Node) -> Option<&str> {
        node.children().iter().filter_map(|child| self.nodes.get(child)).find_map(|child| {
            let own = (child.role() == Role::Heading).then(|| child.label().or(child.value())).flatten();
            own.or_else(|| self.heading(child))
        })
    }

    /// The accessible name: its own, or those of its labels; of a dialog its heading, of a list what opened it.
    fn name(&self, node: &Node) -> String {
        if let Some(label) = node.label() {
            return label.to_owned();
        }
        let labels = node.labelled_by().iter().filter_map(|id| self.nodes.get(id));
        let names: Vec<&str> = labels.filter_map(|label| label.value().or(label.label())).collect();
        match node.role() {
            _ if !names.is_empty() => names.join(" "),
            Role::Dialog | Role::AlertDialog => self.heading(node).unwrap_or_default().to_owned(),
            Role::ListBox => self.open.clone(),
            _ => String::new(),
        }
    }
}

#[cfg(test)]
mod tests {
    use egui::accesskit::{TreeId, TreeInfo};

    use super::*;

    const ROOT: NodeId = NodeId(1);

    fn outline(nodes: Vec<(NodeId, Node)>) -> Outline {
        let tree = Some(TreeInfo::new(ROOT));
        Outline::of(&TreeUpdate { nodes, tree, tree_id: TreeId::ROOT, focus: ROOT }, 1.0)
            .expect("there is a root")
    }

    fn node(role: Role, name: &str, children: &[u64]) -> Node {
        let mut node = Node::new(role);
        if !name.is_empty() {
            node.set_label(name);
        }
        node.set_children(children.iter().copied().map(NodeId).collect::<Vec<_>>());
        node
    }

    fn ids(ids: &[u64]) -> Vec<NodeId> {
        ids.iter().copied().map(NodeId).collect()
    }

    #[test]
    fn elements_stand_in_the_order_of_the_tree_whatever_that_of_the_nodes() {
        let outline = outline(vec![
            (NodeId(4), node(Role::Button, "Undo", &[])),
            (NodeId(3), node(Role::Button, "Redo", &[])),
            (NodeId(2), node(Role::GenericContainer, "", &[4, 3])),
            (ROOT, node(Role::Window, "", &[2, 5])),
            (NodeId(5), node(Role::Label, "Ready", &[])),
        ]);
        assert_eq!(outline.orders, [(None, ids(&[4, 3, 5]))]);
    }

    #[test]
    fn holders_hold_and_widgets_are_followed_by_what_lies_in_them() {
        let outline = outline(vec![
            (ROOT, node(Role::Window, "", &[2, 6])),
            (NodeId(2), node(Role::Region, "Modes", &[3])),
            (NodeId(3), node(Role::Button, "Phugoid", &[4])),
            (NodeId(4), node(Role::Label, "period 27 s", &[])),
            (NodeId(6), node(Role::Button, "Help", &[])),
        ]);
        assert_eq!(outline.orders, [(Some(NodeId(2)), ids(&[3, 4])), (None, ids(&[2, 6]))]);
    }

    #[test]
    fn hidden_nodes_runs_of_text_and_children_that_are_missing_are_left_out() {
        let mut hidden = node(Role::Button, "Secret", &[3]);
        hidden.set_hidden();
        let outline = outline(vec![
            (ROOT, node(Role::Window, "", &[2, 4, 9, 5])),
            (NodeId(2), hidden),
            (NodeId(3), node(Role::Button, "Inside", &[])),
            (NodeId(4), node(Role::TextRun, "run", &[])),
            (NodeId(5), node(Role::Button, "Shown", &[])),
        ]);
        assert_eq!(outline.orders, [(None, ids(&[5]))]);
    }

    #[test]
    fn a_node_that_is_named_twice_or_holds_itself_is_there_once() {
        let outline = outline(vec![
            (ROOT, node(Role::Window, "", &[2, 2])),
            (NodeId(2), node(Role::Region, "Ring", &[3])),
            (NodeId(3), node(Role::Button, "Back", &[2])),
        ]);
        assert_eq!(outline.orders, [(Some(NodeId(2)), ids(&[3])), (None, ids(&[2]))]);
    }

    #[test]
    fn a_node_without_a_name_has_those_of_its_labels() {
        let mut slider = Node::new(Role::Slider);
        slider.set_labelled_by(vec![NodeId(3), NodeId(4)]);
        let mut label = Node::new(Role::Label);
        label.set_value("True airspeed");
        let outline = outline(vec![
            (ROOT, node(Role::Window, "", &[2])),
            (NodeId(2), slider),
            (NodeId(3), label),
            (NodeId(4), node(Role::Label, "V", &[])),
        ]);
        assert_eq!(outline.pictures[0].1.spoken().0, "True airspeed V");
    }

    #[test]
    fn a_dialog_is_named_by_its_heading_and_a_list_by_what_opened_it() {
        let mut chooser = node(Role::ComboBox, "Aircraft", &[]);
        chooser.set_expanded(true);
        let outline = outline(vec![
            (ROOT, node(Role::Window, "", &[2, 3, 6, 8])),
            (NodeId(2), chooser),
            (NodeId(3), node(Role::Dialog, "", &[4])),
            (NodeId(4), node(Role::GenericContainer, "", &[5])),
            (NodeId(5), node(Role::Heading, "Keys", &[])),
            (NodeId(6), node(Role::ListBox, "", &[7])),
            (NodeId(7), node(Role::Button, "Navion", &[])),
            // It has no heading, so it only arranges.
            (NodeId(8), node(Role::Dialog, "", &[9])),
            (NodeId(9), node(Role::Button, "Close", &[])),
        ]);
        let name = |id: u64| {
            let picture = outline.pictures.iter().find(|(of, _)| *of == NodeId(id));
            picture.map(|(_, picture)| picture.spoken().0)
        };
        assert_eq!((name(3).as_deref(), name(6).as_deref(), name(8)), (Some("Keys"), Some("Aircraft"), None));
    }

    #[test]
    fn headings_leave_no_level_out() {
        let levels = [1, 3, 3, 2, 3, 5, 2];
        let headings = levels.iter().zip(2..).map(|(level, id)| {
            let mut heading = node(Role::Heading, "Modes", &[]);
            heading.set_level(*level);
            (NodeId(id), heading)
        });
        let mut nodes: Vec<(NodeId, Node)> = headings.collect();
        nodes.push((ROOT, node(Role::Window, "", &[2, 3, 4, 5, 6, 7, 8])));
        let kinds: Vec<Kind> = outline(nodes).pictures.iter().map(|(_, picture)| picture.kind).collect();
        assert_eq!(kinds, [1, 2, 2, 2, 3, 4, 2].map(Kind::Heading));
    }

    #[test]
    fn a_menu_with_fields_in_it_is_no_menu() {
        let menu = |role: Role| {
            let outline = outline(vec![
                (ROOT, node(Role::Window, "", &[2])),
                (NodeId(2), node(Role::Menu, "", &[3])),
                (NodeId(3), node(role, "Height", &[])),
            ]);
            outline.pictures.iter().any(|(_, picture)| picture.kind == Kind::Holder("menu"))
        };
        assert!(menu(Role::Button) && !menu(Role::CheckBox));
    }

    #[test]
    fn an_update_without_a_root_has_no_outline() {
        let update = TreeUpdate { nodes: Vec::new(), tree: None, tree_id: TreeId::ROOT, focus: ROOT };
        assert!(Outline::of(&update, 1.0).is_none());
    }

    /// Name and value of each element of a frame, as a screen reader would say them.
    fn spoken(add: impl Fn(&mut egui::Ui)) -> Vec<(String, String)> {
        let ctx = egui::Context::default();
        ctx.enable_accesskit();
        let mut output = ctx.run_ui(egui::RawInput::default(), |ui| add(ui));
        // Pictures of letters that nobody draws.
        output.textures_delta.clear();
        let update = output.platform_output.accesskit_update.expect("it was asked for");
        let outline = Outline::of(&update, 1.0).expect("there is a root");
        outline.pictures.iter().map(|(_, picture)| picture.spoken()).collect()
    }

    #[test]
    fn what_egui_draws_is_read_from_top_to_bottom_by_name_and_value() {
        let spoken = spoken(|ui| {
            ui.heading("Flight");
            ui.add(egui::Slider::new(&mut 60.0, 20.0..=90.0).text("Speed").show_value(false));
            ui.checkbox(&mut true, "Turbulence");
            let _ = ui.button("Fly");
        });
        let at = |name: &str, value: &str| {
            let wanted = (name.to_owned(), value.to_owned());
            let place = spoken.iter().position(|spoken| *spoken == wanted);
            place.unwrap_or_else(|| panic!("no {wanted:?} in {spoken:?}"))
        };
        let places = [at("Speed", "60"), at("Turbulence", "checked"), at("Fly", "button")];
        assert!(places.is_sorted(), "{spoken:?}");
        assert_eq!(spoken[0].0, "Flight");
    }
}
