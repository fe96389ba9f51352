; Sitewright's built-in domain: one target component is brought from stock to its place by a
; team of robots. Places are named by what is there. Costs are tenths of a second.
(define (domain assembly)
(:requirements :typing :adl :action-costs)
(:types
  robot thing place end-effector skill - object
  handler finisher all-rounder - robot
  stock-place target fastener finish station - place
  preparation-station tool-station - station
  gripper tool - end-effector)
(:constants retracting grasping positioning releasing fastening finishing tool-changing - skill)
(:predicates
  ; static: what the cell, the model and the planning twin know
  (can ?r - robot ?k - skill)
  (accepts ?r - robot ?e - end-effector)
  (can-reach ?r - robot ?p - place)
  (can-grasp ?r - robot ?e - gripper ?m - thing)
  (can-place ?r - robot ?m - thing ?t - target)
  (can-set-down ?r - robot ?m - thing ?p - stock-place)
  (excludes ?r - robot ?p ?q - place)
  (matches ?m - thing ?t - target)
  (ready ?t - target)
  (spot-of ?p - place ?t - target)
  (tacks ?c - fastener ?t - target)
  (driven-after ?p - place ?b - fastener)
  (drives ?e - tool ?c - fastener)
  (applies ?e - tool ?f - finish)
  ; state: what skills change
  (at ?r - robot ?p - place)
  (in-transit ?r - robot)
  (mobile ?r - robot)
  (vacant ?p - place)
  (hand-empty ?r - robot)
  (holding ?r - robot ?m - thing)
  (steadying ?r - robot ?t - target)
  (mounted ?r - robot ?e - end-effector)
  (docked ?e - end-effector ?s - tool-station)
  (lies-at ?m - thing ?p - stock-place)
  (accessible ?m - thing)
  (pending ?t - target)
  (in-place ?m - thing ?t - target)
  (positioned ?t - target)
  (standing ?t - target)
  (fastened ?c - fastener)
  (finished ?f - finish))
(:functions
  (total-cost)
  (reach-time ?r - robot ?p - place)
  (skill-time ?r - robot ?k - skill) - number)

; Go from free space to a place. Not before the piece is there, and not into another's way.
(:action reach
  :parameters (?r - robot ?p - place)
  :precondition (and (in-transit ?r) (vacant ?p) (can-reach ?r ?p)
    (forall (?t - target) (imply (spot-of ?p ?t) (positioned ?t)))
    (forall (?q - place) (imply (excludes ?r ?p ?q) (vacant ?q))))
  :effect (and (not (in-transit ?r)) (at ?r ?p) (not (vacant ?p))
    (increase (total-cost) (reach-time ?r ?p))))

; Leave a place for free space (or, if nothing follows, for the parking posture).
(:action retract
  :parameters (?r - robot ?p - place)
  :precondition (and (at ?r ?p) (mobile ?r))
  :effect (and (not (at ?r ?p)) (in-transit ?r) (vacant ?p)
    (increase (total-cost) (skill-time ?r retracting))))

(:action grasp
  :parameters (?r - robot ?m - thing ?p - stock-place ?e - gripper)
  :precondition (and (can ?r grasping) (at ?r ?p) (lies-at ?m ?p) (accessible ?m) (hand-empty ?r)
    (mounted ?r ?e) (can-grasp ?r ?e ?m))
  :effect (and (holding ?r ?m) (not (hand-empty ?r)) (not (lies-at ?m ?p)) (not (accessible ?m))
    (increase (total-cost) (skill-time ?r grasping))))

; Put the piece at its target pose and keep steadying it: the robot is not mobile until release.
(:action position
  :parameters (?r - robot ?m - thing ?t - target)
  :precondition (and (can ?r positioning) (at ?r ?t) (holding ?r ?m) (matches ?m ?t) (pending ?t)
    (ready ?t) (can-place ?r ?m ?t))
  :effect (and (not (holding ?r ?m)) (steadying ?r ?t) (not (mobile ?r)) (not (pending ?t))
    (in-place ?m ?t) (positioned ?t) (increase (total-cost) (skill-time ?r positioning))))

(:action set-down
  :parameters (?r - robot ?m - thing ?p - stock-place)
  :precondition (and (can ?r positioning) (at ?r ?p) (holding ?r ?m) (can-set-down ?r ?m ?p))
  :effect (and (not (holding ?r ?m)) (hand-empty ?r) (lies-at ?m ?p) (accessible ?m)
    (increase (total-cost) (skill-time ?r positioning))))

; Let go once every fastener that tacks the piece is driven.
(:action release
  :parameters (?r - robot ?t - target)
  :precondition (and (at ?r ?t) (steadying ?r ?t)
    (forall (?c - fastener) (imply (tacks ?c ?t) (fastened ?c))))
  :effect (and (not (steadying ?r ?t)) (mobile ?r) (hand-empty ?r) (standing ?t)
    (increase (total-cost) (skill-time ?r releasing))))

(:action fasten
  :parameters (?r - robot ?c - fastener ?t - target ?e - tool)
  :precondition (and (can ?r fastening) (at ?r ?c) (spot-of ?c ?t) (positioned ?t) (mounted ?r ?e)
    (drives ?e ?c) (forall (?b - fastener) (imply (driven-after ?c ?b) (fastened ?b))))
  :effect (and (fastened ?c) (increase (total-cost) (skill-time ?r fastening))))

(:action apply-finish
  :parameters (?r - robot ?f - finish ?t - target ?e - tool)
  :precondition (and (can ?r finishing) (at ?r ?f) (spot-of ?f ?t) (standing ?t) (mounted ?r ?e)
    (applies ?e ?f) (forall (?b - fastener) (imply (driven-after ?f ?b) (fastened ?b))))
  :effect (and (finished ?f) (increase (total-cost) (skill-time ?r finishing))))

(:action change-end-effector
  :parameters (?r - robot ?old ?new - end-effector ?s - tool-station)
  :precondition (and (can ?r tool-changing) (at ?r ?s) (hand-empty ?r) (mounted ?r ?old)
    (docked ?new ?s) (accepts ?r ?old) (accepts ?r ?new))
  :effect (and (not (mounted ?r ?old)) (mounted ?r ?new) (docked ?old ?s) (not (docked ?new ?s))
    (increase (total-cost) (skill-time ?r tool-changing)))))
