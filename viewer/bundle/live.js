// Built from viewer/live/.
