/* How fast a ball leaves a robot at full speed in the original's kind of engine (ADR 13).
 *
 * The original computes with the Open Dynamics Engine (ODE) in one step of 32 ms. This builds its robot, ball and floor
 * in ODE from the numbers that ADR 13 lists, and prints what can be compared: how they rest, how the robot starts,
 * and how fast the ball leaves a hit, for several places on the face and 32 moments within a step.
 *
 *     apt install gcc pkg-config libode-dev
 *     gcc -O2 $(pkg-config --cflags ode) benchmarks/original_engine/hit.c -o /tmp/hit $(pkg-config --libs ode) -lm && /tmp/hit
 *
 * Metres, seconds, kilograms, radians, also in what it prints; the robot looks along +x.
 */
#include <math.h>
#include <ode/ode.h>
#include <stdio.h>

static const double STEP_S = 0.032;
static const double SPRING_N_PER_M = 6250, DAMPER_NS_PER_M = 800; /* of each contact point */
static const double FRICTION = 1, RESTITUTION = 0.5, BOUNCES_FROM_MPS = 0.01, GRAVITY_MPS2 = 9.81;
static const double CUBE_M = 0.075, CUBE_KG = 0.2, WHEEL_R_M = 0.02, WHEEL_WIDTH_M = 0.01, WHEEL_KG = 0.005;
static const double WHEEL_ARM_M = 0.045, AXLE_BELOW_M = 0.0176, CENTRE_M = 0.0376, MOTOR_NM = 10, FULL_RADPS = 10;
static const double BALL_R_M = 0.021, BALL_KG = 0.05, BALL_REST_M = 0.0209;
enum { MOMENTS = 32, SETTLING_STEPS = 10, POINTS = 10 };

static dWorldID world;
static dSpaceID space;
static dJointGroupID contacts;
static dBodyID cube, ball;
static dJointID wheels[2];
static dGeomID robot_geoms[3];

static int is_robot(dGeomID geom) {
  return geom == robot_geoms[0] || geom == robot_geoms[1] || geom == robot_geoms[2];
}

static void touch(void *unused, dGeomID one, dGeomID other) {
  (void)unused;
  if (is_robot(one) && is_robot(other)) return;
  dContact found[POINTS];
  int count = dCollide(one, other, POINTS, &found[0].geom, sizeof(dContact));
  for (int i = 0; i < count; i++) {
    dSurfaceParameters *surface = &found[i].surface;
    surface->mode = dContactBounce | dContactSoftERP | dContactSoftCFM | dContactApprox1;
    surface->mu = FRICTION;
    surface->bounce = RESTITUTION;
    surface->bounce_vel = BOUNCES_FROM_MPS;
    surface->soft_cfm = 1 / (STEP_S * SPRING_N_PER_M + DAMPER_NS_PER_M);
    surface->soft_erp = STEP_S * SPRING_N_PER_M * surface->soft_cfm;
    dJointAttach(dJointCreateContact(world, contacts, &found[i]), dGeomGetBody(one), dGeomGetBody(other));
  }
}

static void steps(int count) {
  for (; count > 0; count--) {
    dSpaceCollide(space, 0, touch);
    dWorldStep(world, STEP_S);
    dJointGroupEmpty(contacts);
  }
}

static dBodyID body(dMass *mass, dGeomID geom, double x, double y, double z) {
  dBodyID made = dBodyCreate(world);
  dBodySetMass(made, mass);
  dGeomSetBody(geom, made);
  dBodySetPosition(made, x, y, z);
  return made;
}

static void add_wheel(int side, double y) {
  dMass mass;
  dMassSetCylinderTotal(&mass, WHEEL_KG, 3, WHEEL_R_M, WHEEL_WIDTH_M);
  dGeomID geom = robot_geoms[1 + side] = dCreateCylinder(space, WHEEL_R_M, WHEEL_WIDTH_M);
  dBodyID wheel = body(&mass, geom, 0, y, CENTRE_M - AXLE_BELOW_M);
  dMatrix3 lying;
  dRFromAxisAndAngle(lying, 1, 0, 0, M_PI / 2);
  dBodySetRotation(wheel, lying);
  wheels[side] = dJointCreateHinge(world, 0);
  dJointAttach(wheels[side], wheel, cube);
  dJointSetHingeAnchor(wheels[side], 0, y, CENTRE_M - AXLE_BELOW_M);
  dJointSetHingeAxis(wheels[side], 0, 1, 0);
  dJointSetHingeParam(wheels[side], dParamFMax, MOTOR_NM);
}

static void drive(double left_radps, double right_radps) {
  dJointSetHingeParam(wheels[0], dParamVel, left_radps);
  dJointSetHingeParam(wheels[1], dParamVel, right_radps);
}

static void build(double ball_x, double ball_y) {
  dMass mass;
  world = dWorldCreate();
  space = dHashSpaceCreate(0);
  contacts = dJointGroupCreate(0);
  dWorldSetGravity(world, 0, 0, -GRAVITY_MPS2);
  dCreatePlane(space, 0, 0, 1, 0);
  dMassSetBoxTotal(&mass, CUBE_KG, CUBE_M, CUBE_M, CUBE_M);
  robot_geoms[0] = dCreateBox(space, CUBE_M, CUBE_M, CUBE_M);
  cube = body(&mass, robot_geoms[0], 0, 0, CENTRE_M);
  add_wheel(0, WHEEL_ARM_M);
  add_wheel(1, -WHEEL_ARM_M);
  dMassSetSphereTotal(&mass, BALL_KG, BALL_R_M);
  ball = body(&mass, dCreateSphere(space, BALL_R_M), ball_x, ball_y, BALL_REST_M);
  steps(SETTLING_STEPS);
}

static void clear(void) {
  dJointGroupDestroy(contacts);
  dSpaceDestroy(space);
  dWorldDestroy(world);
}

static double ball_speed_mps(void) {
  const dReal *velocity = dBodyGetLinearVel(ball);
  return hypot(velocity[0], velocity[1]);
}

static void show_rest_and_start(void) {
  build(1, 0);
  printf("at rest: cube's centre %.4f, ball's %.4f, tilt %.4f\n", dBodyGetPosition(cube)[2], dBodyGetPosition(ball)[2],
         acos(fmin(1, dBodyGetRotation(cube)[10])));
  drive(FULL_RADPS, FULL_RADPS);
  printf("speed after each step from rest:");
  for (int i = 0; i < 4; i++) {
    steps(1);
    printf(" %.3f", dBodyGetLinearVel(cube)[0]);
  }
  steps(60);
  printf("; after 2 s %.4f, tilt %.4f\n", dBodyGetLinearVel(cube)[0], acos(fmin(1, dBodyGetRotation(cube)[10])));
  clear();
  build(1, 0);
  drive(-FULL_RADPS, FULL_RADPS);
  printf("turning after each step from rest:");
  for (int i = 0; i < 4; i++) {
    steps(1);
    printf(" %.2f", dBodyGetAngularVel(cube)[2]);
  }
  printf("\n");
  clear();
}

static void show_hits(double offset_m) {
  double least = 1, most = 0, sum = 0;
  for (int moment = 0; moment < MOMENTS; moment++) {
    build(0.4 + 0.0064 * moment / MOMENTS, offset_m);
    drive(FULL_RADPS, FULL_RADPS);
    steps(100);
    double speed = ball_speed_mps();
    least = fmin(least, speed);
    most = fmax(most, speed);
    sum += speed;
    clear();
  }
  printf("ball %.3f beside the middle of the face: leaves with %.4f (%.4f to %.4f)\n", offset_m, sum / MOMENTS, least,
         most);
}

int main(void) {
  dInitODE2(0);
  show_rest_and_start();
  for (int mm = 0; mm <= 35; mm += 5) show_hits(mm / 1000.0);
  dCloseODE();
  return 0;
}
