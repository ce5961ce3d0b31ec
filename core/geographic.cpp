/* SPDX-License-Identifier: MIT */
/* The one C++ file: converts units and axes, catches everything, keeps models in opaque handles. */
#include "core/geographic_data.h"

#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Geodesic.hpp>
#include <GeographicLib/GravityModel.hpp>
#include <GeographicLib/NormalGravity.hpp>

#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <memory>
#include <new>
#include <string>

using GeographicLib::Geocentric;
using GeographicLib::Geodesic;
using GeographicLib::GravityModel;
using GeographicLib::NormalGravity;

namespace
{
constexpr double deg_per_rad = 180.0 / SCHULER_PI;
constexpr double rad_per_deg = SCHULER_PI / 180.0;

/* FOLDER/NAME:DEGREE, of which NAME alone is needed. */
struct data_set {
    std::string folder, name;
    int degree = -1;
};

/* A data set's name becomes part of a file name, so nothing that could leave the folder is let in.
 */
bool is_plain_name(const std::string &name)
{
    if (name.empty() || name.size() > 64) return false;
    for (const char c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') return false;
    return true;
}

data_set data_set_of(const std::string &text)
{
    data_set d;
    const size_t slash = text.rfind('/');
    if (slash != std::string::npos) d.folder = slash == 0 ? "/" : text.substr(0, slash);
    d.name = slash == std::string::npos ? text : text.substr(slash + 1);
    const size_t colon = d.name.find(':');
    if (colon != std::string::npos) {
        const std::string digits = d.name.substr(colon + 1);
        d.name.resize(colon);
        const bool is_number = !digits.empty() && digits.size() < 6 &&
                               digits.find_first_not_of("0123456789") == std::string::npos;
        d.degree = is_number ? std::atoi(digits.c_str()) : -2;
    }
    return d;
}

schuler_status fail_data(schuler_error *err, const char *text, const char *reason)
{
    const data_set d = data_set_of(text);
    const char *const name = is_plain_name(d.name) ? d.name.c_str() : "egm96";
    return schuler_fail(
        err, SCHULER_ERR_GRAVITY_DATA, nullptr,
        "gravity model '%.64s': %.120s; built in are wgs84 and grs80, others are data sets: "
        "install with 'geographiclib-get-gravity %.64s' (Debian package geographiclib-tools), or "
        "set "
        "GEOGRAPHICLIB_GRAVITY_PATH to their folder",
        text, reason, name);
}

template <size_t size> void copy(char (&out)[size], const char *text)
{
    std::snprintf(out, size, "%s", text);
}
} // namespace

struct schuler_field {
    const NormalGravity *normal = nullptr; /* GeographicLib's own, or the one inside model */
    std::unique_ptr<GravityModel> model;   /* egm names only */
};

extern "C" {

schuler_vec3 schuler_ecef_from_llh(schuler_llh p)
{
    schuler_vec3 r_e = { { 0.0, 0.0, 0.0 } };
    Geocentric::WGS84().Forward(p.lat_rad * deg_per_rad, p.lon_rad * deg_per_rad, p.h_m, r_e.v[0],
                                r_e.v[1], r_e.v[2]);
    return r_e;
}

schuler_llh schuler_llh_from_ecef(schuler_vec3 r_e)
{
    double lat_deg = 0.0, lon_deg = 0.0, h_m = 0.0;
    Geocentric::WGS84().Reverse(r_e.v[0], r_e.v[1], r_e.v[2], lat_deg, lon_deg, h_m);
    return { lat_deg * rad_per_deg, lon_deg * rad_per_deg, h_m };
}

void schuler_geodesic_inverse(double lat1_rad, double lon1_rad, double lat2_rad, double lon2_rad,
                              double *s12_m, double *azi1_rad, double *azi2_rad)
{
    double azi1_deg = 0.0, azi2_deg = 0.0;
    Geodesic::WGS84().Inverse(lat1_rad * deg_per_rad, lon1_rad * deg_per_rad,
                              lat2_rad * deg_per_rad, lon2_rad * deg_per_rad, *s12_m, azi1_deg,
                              azi2_deg);
    *azi1_rad = azi1_deg * rad_per_deg;
    *azi2_rad = azi2_deg * rad_per_deg;
}

void schuler_geodesic_direct(double lat1_rad, double lon1_rad, double azi1_rad, double s12_m,
                             double *lat2_rad, double *lon2_rad, double *azi2_rad)
{
    double lat2_deg = 0.0, lon2_deg = 0.0, azi2_deg = 0.0;
    Geodesic::WGS84().Direct(lat1_rad * deg_per_rad, lon1_rad * deg_per_rad, azi1_rad * deg_per_rad,
                             s12_m, lat2_deg, lon2_deg, azi2_deg);
    *lat2_rad = lat2_deg * rad_per_deg;
    *lon2_rad = lon2_deg * rad_per_deg;
    *azi2_rad = azi2_deg * rad_per_deg;
}

schuler_status schuler_field_open(schuler_field_model **out, const char *name, schuler_error *err)
try {
    auto field = std::make_unique<schuler_field>();
    if (std::strcmp(name, "wgs84") == 0) {
        field->normal = &NormalGravity::WGS84();
    } else if (std::strcmp(name, "grs80") == 0) {
        field->normal = &NormalGravity::GRS80();
    } else {
        const data_set d = data_set_of(name);
        if (!is_plain_name(d.name))
            return fail_data(err, name, "a name has only letters, digits, '-' and '_'");
        if (d.degree == -2 || d.degree == 0 || d.degree == 1)
            return fail_data(err, name, "a degree is a whole number from 2 on, as in egm96:120");
        field->model = std::make_unique<GravityModel>(d.name, d.folder, d.degree);
        field->normal = &field->model->ReferenceEllipsoid();
    }
    *out = field.release();
    return SCHULER_OK;
} catch (const std::bad_alloc &) {
    return schuler_fail(err, SCHULER_ERR_MEMORY, nullptr, "out of memory for gravity model '%s'",
                        name);
} catch (const std::exception &e) {
    return fail_data(err, name, e.what());
} catch (...) {
    return fail_data(err, name, "cannot be loaded");
}

void schuler_field_close(schuler_field_model *field)
{
    delete field;
}

void schuler_field_folder(char *out, size_t size)
try {
    std::snprintf(out, size, "%s", GravityModel::DefaultGravityPath().c_str());
} catch (...) {
    if (size > 0) out[0] = '\0';
}

/* To degree 2 a model is read in no time, and is checked all the same. */
void schuler_field_describe(const char *folder, schuler_field_data *d)
try {
    std::string name, in;
    name = d->name;
    in = folder;
    const GravityModel model(name, in, 2);
    copy(d->description, model.Description().c_str());
    if (model.DateTime() != "UNKNOWN") copy(d->release, model.DateTime().c_str());
} catch (const std::exception &e) {
    copy(d->problem, e.what());
} catch (...) {
    copy(d->problem, "cannot be read");
}

schuler_vec3 schuler_field_normal_gravitation(const schuler_field_model *field, schuler_vec3 r_e)
{
    schuler_vec3 g_e = { { 0.0, 0.0, 0.0 } };
    field->normal->V0(r_e.v[0], r_e.v[1], r_e.v[2], g_e.v[0], g_e.v[1], g_e.v[2]);
    return g_e;
}

schuler_vec3 schuler_field_gravity(const schuler_field_model *field, schuler_vec3 r_e)
{
    schuler_vec3 g_e = { { 0.0, 0.0, 0.0 } };
    if (field->model)
        field->model->W(r_e.v[0], r_e.v[1], r_e.v[2], g_e.v[0], g_e.v[1], g_e.v[2]);
    else
        field->normal->U(r_e.v[0], r_e.v[1], r_e.v[2], g_e.v[0], g_e.v[1], g_e.v[2]);
    return g_e;
}

int schuler_field_has_disturbance(const schuler_field_model *field)
{
    return field->model != nullptr;
}

double schuler_field_earth_rate(const schuler_field_model *field)
{
    return field->normal->AngularVelocity();
}
}
