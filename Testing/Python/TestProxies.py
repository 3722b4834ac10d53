"""The proxies are what the documented interface says: names, labels, enumerations with their codes, defaults, ports."""

import unittest

import support
from interface import PROXIES
from paraview import simple


def make(name):
    points, triangles = support.torus_mesh(24, 12)
    source = support.source(support.mesh(points, triangles, f=points[:, 2]))
    further = {"RBFEvaluate": "Target", "MeshlessContour": "Surface"}
    inputs = {further[name]: source} if name in further else {}
    return getattr(simple, name)(Input=source, **inputs)


def without_blanks(label):
    return label.replace(" ", "")


class TestProxies(unittest.TestCase):
    def setUp(self):
        self.proxies = {name: make(name) for name in PROXIES}

    def each(self):
        for name, expected in PROXIES.items():
            yield name, self.proxies[name], expected

    def test_properties_have_the_names_of_the_interface(self):
        for _, proxy, expected in self.each():
            wanted = set(expected["defaults"]) | set(expected["enumerations"]) | set(expected["others"])
            self.assertEqual(wanted - set(proxy.ListProperties()), set())

    def test_labels_without_blanks_are_the_names(self):
        for name, proxy, _ in self.each():
            self.assertEqual(without_blanks(proxy.SMProxy.GetXMLLabel()), name)
            for property_name in proxy.ListProperties():
                label = proxy.SMProxy.GetProperty(property_name).GetXMLLabel()
                self.assertEqual(without_blanks(label), property_name)

    def test_enumerations_offer_the_named_codes_and_no_others(self):
        for _, proxy, expected in self.each():
            for property_name, codes in expected["enumerations"].items():
                domain = proxy.SMProxy.GetProperty(property_name).FindDomain("vtkSMEnumerationDomain")
                offered = {
                    domain.GetEntryText(i): domain.GetEntryValue(i) for i in range(domain.GetNumberOfEntries())
                }
                self.assertEqual(offered, codes)

    def test_values_are_set_by_name_and_kept_as_codes(self):
        for _, proxy, expected in self.each():
            for property_name, codes in expected["enumerations"].items():
                for text, code in codes.items():
                    setattr(proxy, property_name, text)
                    self.assertEqual(getattr(proxy, property_name), text)
                    self.assertEqual(proxy.SMProxy.GetProperty(property_name).GetElement(0), code)

    def test_values_of_other_filters_are_refused(self):
        contour = self.proxies["PointSetContour"]
        critical = self.proxies["FuzzyCriticalPoints"]
        for proxy, property_name, value in (
            (contour, "Scheme", "GlobalRBF"),
            (contour, "Kernel", "Harmonic"),
            (critical, "Scheme", "Linear"),
            (critical, "Scheme", "GlobalRBF"),
            (self.proxies["ScalarFunctionDesign"], "EpsilonChoice", "GCV"),
        ):
            with self.assertRaises(ValueError):
                setattr(proxy, property_name, value)

    def test_defaults(self):
        for _, proxy, expected in self.each():
            for property_name, value in expected["defaults"].items():
                found = getattr(proxy, property_name)
                self.assertEqual(list(found) if isinstance(value, list) else found, value, property_name)

    def test_the_value_in_the_middle_is_contoured_by_default(self):
        contour = self.proxies["PointSetContour"]
        low, high = contour.Input.PointData["f"].GetRange()
        self.assertEqual(len(contour.ContourValues), 1)
        self.assertAlmostEqual(contour.ContourValues[0], 0.5 * (low + high), places=12)
        self.assertEqual(list(contour.ScalarArray), ["POINTS", "f"])

    def test_inputs_without_arrays_are_offered_where_something_else_serves(self):
        points, triangles = support.torus_mesh(24, 12)
        source = support.source(support.mesh(points, triangles))
        for name, offered in (("PointSetContour", 1), ("MeshCriticalPoints", 1), ("MorseComplex", 0)):
            proxy = getattr(simple, name)(Input=source)
            self.assertEqual(proxy.SMProxy.GetProperty("Input").IsInDomains(), offered, name)

    def test_implicit_functions_on_offer(self):
        for name, property_name in (("PointSetContour", "CutFunction"), ("FuzzyCriticalPoints", "VolumeFunction")):
            domain = self.proxies[name].SMProxy.GetProperty(property_name).FindDomain("vtkSMProxyListDomain")
            offered = [domain.GetProxyName(i) for i in range(domain.GetNumberOfProxies())]
            self.assertEqual(offered[0], "None")
            self.assertEqual(set(offered), {"None", "Plane", "Sphere", "Box", "Cylinder"})

    def test_places_are_offered_within_the_bounds_of_the_input(self):
        function = self.proxies["PointSetScalarFunction"]
        bounds = function.Input.GetDataInformation().GetBounds()
        for i in range(3):
            self.assertAlmostEqual(function.SourcePoint[i], 0.5 * (bounds[2 * i] + bounds[2 * i + 1]))
            self.assertAlmostEqual(function.ConstraintPoint1[i], bounds[2 * i])
            self.assertAlmostEqual(function.ConstraintPoint2[i], bounds[2 * i + 1])

    def test_output_ports_have_the_names_of_the_interface(self):
        for _, proxy, expected in self.each():
            if expected["ports"]:
                count = proxy.SMProxy.GetNumberOfOutputPorts()
                self.assertEqual([proxy.SMProxy.GetOutputPortName(i) for i in range(count)], expected["ports"])

    def test_filters_are_algorithms_of_the_proxys_name(self):
        for name, proxy, expected in self.each():
            self.assertEqual(proxy.GetClientSideObject().GetClassName(), "vtk" + name)
            self.assertTrue(proxy.GetClientSideObject().IsA(expected.get("superclass", "vtkPolyDataAlgorithm")))

    def test_every_property_has_a_tooltip(self):
        for _, proxy, _ in self.each():
            for property_name in proxy.ListProperties():
                documentation = proxy.SMProxy.GetProperty(property_name).GetDocumentation()
                self.assertIsNotNone(documentation, property_name)
                self.assertGreater(len(documentation.GetDescription().strip()), 10, property_name)

    def test_lists_are_in_groups_as_they_are_shown_without_a_label(self):
        for name, proxy, _ in self.each():
            groups = [proxy.SMProxy.GetPropertyGroup(i) for i in range(proxy.SMProxy.GetNumberOfPropertyGroups())]
            grouped = {group.GetProperty(i).GetXMLName() for group in groups for i in range(group.GetNumberOfProperties())}
            lists = {key for key in proxy.ListProperties() if proxy.SMProxy.GetProperty(key).GetRepeatable()}
            inputs = {key for key in lists if proxy.SMProxy.GetProperty(key).IsA("vtkSMInputProperty")}
            self.assertEqual(lists - inputs - grouped, set(), name)

    def test_filters_are_in_the_menu_surface_scalars(self):
        for _, proxy, _ in self.each():
            menu = proxy.SMProxy.GetHints().FindNestedElementByName("ShowInMenu")
            self.assertEqual(menu.GetAttribute("category"), "Surface Scalars")


if __name__ == "__main__":
    support.load_plugin()
    unittest.main()
