/* Closed triangle meshes of the distance fields in examples/demo/scene.h, by surface nets: one vertex in every cell
   that the surface crosses, moved onto the surface, and two triangles for every edge of the grid that it crosses. */
#ifndef TESTS_RENDER_MESH_H
#define TESTS_RENDER_MESH_H
#include "scene.h"

typedef struct mesh {
    float *position;    /* [vertices + 1][3] mm; one to spare, since Embree reads 16 bytes from each vertex */
    uint32_t *triangle; /* [triangles][3], counter-clockwise seen from outside */
    int vertices, triangles;
} mesh;

static inline void mesh_free(mesh *m)
{
    free(m->position);
    free(m->triangle);
    memset(m, 0, sizeof *m);
}

/* The vertex of a cell with distances d at its 8 corners: the middle of its crossed edges, then two Newton steps. */
static inline scene_vec mesh__vertex(scene_object object, scene_vec corner, float cell, const float d[8])
{
    float sum[3] = {0, 0, 0};
    int i, k, axis, crossed = 0;
    scene_vec p;
    for (i = 0; i < 8; ++i)
        for (axis = 0; axis < 3; ++axis) {
            int j = i | 1 << axis;
            if (j == i || (d[i] < 0) == (d[j] < 0)) continue;
            for (k = 0; k < 3; ++k) sum[k] += k == axis ? d[i] / (d[i] - d[j]) : (float)(i >> k & 1);
            ++crossed;
        }
    p = scene_mad(scene_v(sum[0], sum[1], sum[2]), cell / (float)crossed, corner);
    for (i = 0; i < 2; ++i) {
        float distance = scene__clamp(scene_distance(object, p), -0.3f * cell, 0.3f * cell);
        p = scene_mad(scene_gradient(object, p, 0.1f * cell), -distance, p);
    }
    return p;
}

/* 0 where memory ran out or the surface leaves the object's box. */
static inline int mesh_make(mesh *m, scene_object object, float cell)
{
    scene_grid g;
    int x, y, z, i, k, axis, pass, step[3], *vertex_of = NULL, closed = 1;
    memset(m, 0, sizeof *m);
    if (!scene__grid_make(&g, object, cell)) return 0;
    step[0] = 1;
    step[1] = g.nx;
    step[2] = g.nx * g.ny;
    for (pass = 0; pass < 2 && closed; ++pass) { /* count, then fill */
        m->vertices = m->triangles = 0;
        for (z = 0; z < g.nz - 1; ++z)
            for (y = 0; y < g.ny - 1; ++y)
                for (x = 0; x < g.nx - 1; ++x) {
                    int at = z * step[2] + y * step[1] + x, inside = 0;
                    float d[8];
                    for (i = 0; i < 8; ++i) {
                        d[i] = g.distance[at + (i & 1) * step[0] + (i >> 1 & 1) * step[1] + (i >> 2) * step[2]];
                        inside += d[i] < 0;
                    }
                    if (inside == 0 || inside == 8) continue;
                    if (x == 0 || y == 0 || z == 0) closed = 0;
                    if (pass == 1) {
                        scene_vec corner = scene_mad(scene_v((float)x, (float)y, (float)z), cell, g.low);
                        scene_vec v = mesh__vertex(object, corner, cell, d);
                        float *to = m->position + 3 * m->vertices;
                        to[0] = v.x;
                        to[1] = v.y;
                        to[2] = v.z;
                        vertex_of[at] = m->vertices;
                    }
                    m->vertices++;
                    for (axis = 0; axis < 3;
                         ++axis) { /* the edge at corner 0, shared by this cell and three before it */
                        static const int order[2][6] = {{0, 1, 2, 0, 2, 3}, {0, 2, 1, 0, 3, 2}};
                        int u = step[(axis + 1) % 3], w = step[(axis + 2) % 3];
                        if ((d[0] < 0) == (d[1 << axis] < 0)) continue;
                        for (k = 0; k < 6 && pass == 1; ++k) {
                            int corner = order[d[0] >= 0][k];
                            int cell_at = at - (corner < 2 ? w : 0) - (corner == 0 || corner == 3 ? u : 0);
                            m->triangle[3 * m->triangles + k] = (uint32_t)vertex_of[cell_at];
                        }
                        m->triangles += 2;
                    }
                }
        if (pass == 0) {
            vertex_of = (int *)malloc((size_t)step[2] * (size_t)g.nz * sizeof *vertex_of);
            m->position = (float *)calloc(3 * ((size_t)m->vertices + 1), sizeof(float));
            m->triangle = (uint32_t *)malloc(3 * (size_t)m->triangles * sizeof(uint32_t));
            closed = closed && vertex_of && m->position && m->triangle;
        }
    }
    free(vertex_of);
    free(g.distance);
    if (!closed) mesh_free(m);
    return closed;
}
#endif
