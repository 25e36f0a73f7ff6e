/* The IMU beside the sensors; its registers stand in plan.h. */
#pragma once
#include "plan.h"

#ifdef IMU_ADDRESS
void imu_read(void);  /* with the chips, before the line */
void imu_send(void);  /* six cells: acceleration in m/s^2, angular rate in rad/s; empty where it is silent */
void imu_watch(void); /* set up where it does not answer; call once a second */
#else
static inline void imu_read(void) {}
static inline void imu_send(void) {}
static inline void imu_watch(void) {}
#endif
